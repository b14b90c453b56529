#pragma once
// NavigationScene: the 3-D picture of the paper's figure 9: textured brain, translucent scalp, coil with its
// axis as a line into the brain, target, MRI slices. Last stage of the data flow: from RigidTransforms to
// pixels. In the default view (`head_fixed`) World = Mri and the coil moves around a fixed head. In the view
// `camera` World = Camera, seen from the left camera's position. Per frame only two vtkTransforms are set;
// nothing is rebuilt. When head or coil is lost, the coil and its axis are hidden, the scene is grey, and the
// banner's text is shown. Not thread-safe: use it on the rendering thread only. Needs an X display
// (display.h).

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "facenav/core/rgb_image.h"
#include "facenav/core/tracked.h"
#include "facenav/guidance/target.h"
#include "facenav/scene/coil_shape.h"
#include "facenav/scene/cortex_picture.h"
#include "facenav/surface/brain_model.h"
#include "facenav/volume/volume.h"

class vtkRenderer;
class vtkRenderWindow;

namespace facenav::scene {

enum class ViewFrame { head_fixed, camera };
/// Viewing direction; `target`: along the surface over the active target, or `left_front` if there is none.
enum class ViewPreset { target, front, back, left, right, top, left_front, right_front };

/// The phi-theta model; the detailed cortex with the MRI at the peel depth; or the cortex coloured by its
/// distance from the model.
enum class BrainLook { model, cortex, distance };

struct SceneLayers {
  bool scalp = true, brain = true, coil = true, targets = true, coil_axis = true;
  bool axial = false, coronal = false, sagittal = false;  // slices along the scanner's axes
  double scalp_opacity = 0.55;                            // at the rim; lower at the front
};

/// The surface point under the mouse.
struct ScenePick {
  Point<Mri> point;
  bool is_brain = false;  // else scalp
};

/// The current projection: (x, y, z, w) = M (Mri mm, 1). x / w (right) and y / w (up) run from -1 to 1 over
/// the view; w > 0 in front of the eye.
struct SceneProjection {
  Eigen::Matrix4d screen_from_mri;
  Point<Mri> eye;
};

class NavigationScene {
 public:
  NavigationScene();
  ~NavigationScene();
  NavigationScene(const NavigationScene&) = delete;
  NavigationScene& operator=(const NavigationScene&) = delete;

  // Set once per case.
  void setScalp(const surface::TriangleMesh& scalp);
  void setBrain(const surface::BrainModel& brain);
  /// Sets the detailed cortex, for the other looks; null: none. setBrain() removes it.
  void setCortex(std::shared_ptr<const CortexPicture> cortex);
  void clearBrain();
  void setVolume(const volume::Volume& mri);
  void setTargets(const std::vector<guidance::Target>& targets, const std::string& active);
  void setCoilShape(const CoilShape& shape);
  /// Sets the planned coil, drawn faintly at a target's pose; nullopt: hidden.
  void setCoilGhost(const std::optional<RigidTransform<Mri, Target>>& mri_T_target);

  // The user's choices.
  /// Colours of the background, from the bottom to the top. The scene's words are white in any of them.
  void setBackground(const palette::Rgb& bottom, const palette::Rgb& top);
  /// Sets the size of all text in the scene, as a factor of the usual one. Takes effect with attach() and
  /// render().
  void setTextScale(double scale);
  void setLayers(const SceneLayers& layers);
  void setBrainLook(BrainLook look);
  /// Speeds up drawing while the view or the peel depth moves: larger triangles and rougher edges take a
  /// third of the time. The layers of the translucent skin cost as much again; they are left out if
  /// `is_skin_shown` is false.
  void setQuick(bool is_quick, bool is_skin_shown = true);
  /// Makes both scenes share one camera; `other` defines the views and presets.
  void shareCamera(NavigationScene& other);
  /// Sets the peel depth, 0..40 mm, for the look `cortex`; takes a few milliseconds.
  void setPeelDepth(double depth_mm);
  void setSliceCentre(const Point<Mri>& centre);
  /// Draws the two slices of this MRI along the live coil's axis over the head; null: none. Not drawn while
  /// head or coil is lost.
  void setCoilSlices(std::shared_ptr<const volume::Volume> mri);
  bool showsCoilSlices() const;
  void setView(ViewPreset preset);
  void setViewFrame(ViewFrame frame);
  /// Sets the left camera's vertical angle of view, for ViewFrame::camera.
  void setCameraAngle(double vertical_rad);

  // Set for every frame.
  void setHeadPose(const Tracked<RigidTransform<Camera, Mri>>& camera_T_mri);
  void setCoilPose(const Tracked<RigidTransform<Camera, Coil>>& camera_T_coil);
  /// Colours ring and axis blue while on target.
  void setOnTarget(bool is_on_target);
  /// Sets the text over the scene; empty: none. It is shown whether or not a pose is lost. A long text is
  /// broken into lines that fit into the view.
  void setBanner(const std::string& words);
  /// Sets whether live poses are expected. False (planning): nothing is greyed.
  void setLive(bool is_live);

  /// True while coil and axis are drawn.
  bool showsCoil() const;

  vtkRenderer* renderer() const;
  /// Adds the scene (3-D, lines on top, head icon) to a window, in the viewport x0 y0 x1 y1 (0..1).
  void attach(vtkRenderWindow* window, double x0 = 0, double y0 = 0, double x1 = 1, double y1 = 1);
  /// Nearest surface under a display pixel (origin bottom-left, as in VTK).
  std::optional<ScenePick> pick(int x_px, int y_px) const;
  /// Projection for a view of `width_px` by `height_px` that the scene fills.
  SceneProjection projection(int width_px, int height_px) const;
  /// Renders offscreen.
  RgbImage render(int width_px, int height_px);

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace facenav::scene
