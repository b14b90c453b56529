#pragma once
// NavigationScene: the 3-D picture of the paper's figure 9: textured brain, translucent scalp, coil with its
// axis as a line into the brain, target, overlaid MRI slices. Last stage of the data flow: takes
// RigidTransforms, gives pixels. World = Mri in the default view (`head_fixed`: the coil moves round a head
// that stands still); in the view `camera` world = Camera, seen from the left camera's place. Per frame only
// two vtkTransforms are set and nothing is rebuilt. When head or coil is lost the coil and its axis are
// hidden, the scene is greyed, and the banner's words shown. Not thread-safe: belongs to the thread that
// renders. Needs an X display (display.h).

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
/// From where the head is seen; `target`: along the surface over the active target, else as `left_front`.
enum class ViewPreset { target, front, back, left, right, top, left_front, right_front };

/// The phi-theta model; the detailed cortex with the MRI at the peel depth; the cortex coloured by its
/// distance from the model.
enum class BrainLook { model, cortex, distance };

struct SceneLayers {
  bool scalp = true, brain = true, coil = true, targets = true, coil_axis = true;
  bool axial = false, coronal = false, sagittal = false;  // slices along the scanner's own axes
  double scalp_opacity = 0.55;                            // at the rim; the front is clearer
};

/// What lies under the mouse.
struct ScenePick {
  Point<Mri> point;
  bool is_brain = false;  // else scalp
};

/// How the scene is seen now: (x, y, z, w) = M (Mri mm, 1); x / w and y / w run from -1 to 1 over the view,
/// right and up; w > 0 in front of the eye.
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

  // What changes with the case.
  void setScalp(const surface::TriangleMesh& scalp);
  void setBrain(const surface::BrainModel& brain);
  /// Beside the model, for the other looks; null: none. setBrain() takes it away.
  void setCortex(std::shared_ptr<const CortexPicture> cortex);
  void clearBrain();
  void setVolume(const volume::Volume& mri);
  void setTargets(const std::vector<guidance::Target>& targets, const std::string& active);
  void setCoilShape(const CoilShape& shape);
  /// The planned coil, drawn faint at a target's pose; nothing: hidden.
  void setCoilGhost(const std::optional<RigidTransform<Mri, Target>>& mri_T_target);

  // What the user chooses.
  void setLayers(const SceneLayers& layers);
  void setBrainLook(BrainLook look);
  /// While the view or the peel depth moves: larger triangles, rougher edges, a third of the time; without
  /// the translucent skin, whose layers cost as much again, where `is_skin_shown` is false.
  void setQuick(bool is_quick, bool is_skin_shown = true);
  /// Both scenes are seen from one place from now on; `other` decides where views and presets look from.
  void shareCamera(NavigationScene& other);
  /// 0..40 mm, of the look `cortex`; a few milliseconds.
  void setPeelDepth(double depth_mm);
  void setSliceCentre(const Point<Mri>& centre);
  void setView(ViewPreset preset);
  void setViewFrame(ViewFrame frame);
  /// Camera for ViewFrame::camera: vertical angle of view of the left camera.
  void setCameraAngle(double vertical_rad);

  // What changes with each frame.
  void setHeadPose(const Tracked<RigidTransform<Camera, Mri>>& camera_T_mri);
  void setCoilPose(const Tracked<RigidTransform<Camera, Coil>>& camera_T_coil);
  /// On target: ring and axis turn blue.
  void setOnTarget(bool is_on_target);
  /// Words over the scene; empty: none. They are shown with or without a loss.
  void setBanner(const std::string& words);
  /// False: no live poses are expected (planning); nothing is greyed.
  void setLive(bool is_live);

  /// True where coil and axis are drawn now.
  bool showsCoil() const;

  vtkRenderer* renderer() const;
  /// Puts the scene (3-D, on-top lines, head icon) into a window, in the viewport x0 y0 x1 y1 (0..1).
  void attach(vtkRenderWindow* window, double x0 = 0, double y0 = 0, double x1 = 1, double y1 = 1);
  /// Nearest surface under a display pixel (origin bottom-left, as VTK counts).
  std::optional<ScenePick> pick(int x_px, int y_px) const;
  /// Of a view `width_px` by `height_px` that the scene fills.
  SceneProjection projection(int width_px, int height_px) const;
  /// Renders offscreen.
  RgbImage render(int width_px, int height_px);

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace facenav::scene
