#pragma once
// BrainLayer: the brain in the scene: the phi-theta model, the detailed cortex at a peel depth, or the cortex
// coloured by its distance from the model. Private to scene.

#include <memory>

#include "actors.h"
#include "facenav/scene/cortex_picture.h"
#include "facenav/scene/navigation_scene.h"

class vtkFloatArray;
class vtkUnsignedCharArray;

namespace facenav::scene {

class BrainLayer {
 public:
  BrainLayer(vtkRenderer* renderer, vtkLinearTransform* head) : renderer_(renderer), head_(head) {}

  void setModel(const surface::BrainModel& brain);
  /// Sets the cortex; without one (null) every look shows the model.
  void setCortex(std::shared_ptr<const CortexPicture> cortex);
  void clear();
  void setLook(BrainLook look);
  void setPeelDepth(double depth_mm);
  void setVisible(bool is_visible);
  void setGrey(bool is_grey);
  /// Draws the cortex with larger triangles.
  void setQuick(bool is_quick);
  /// The actor drawn now, or null.
  vtkActor* shown() const;

 private:
  /// The cortex, fine or coarse mesh.
  struct Level {
    vtkSmartPointer<vtkActor> actor;
    vtkSmartPointer<vtkUnsignedCharArray> greys;
    vtkSmartPointer<vtkFloatArray> distances;
    const surface::PeelTexture* peel = nullptr;
  };
  Level makeLevel(const surface::TriangleMesh& mesh, const surface::PeelTexture& peel,
                  const std::vector<float>& distance_mm);
  bool showsDistance() const { return look_ == BrainLook::distance; }
  const Level& level() const { return is_quick_ ? coarse_ : fine_; }
  void update();
  void colourCortex();

  vtkRenderer* renderer_;
  vtkLinearTransform* head_;
  vtkSmartPointer<vtkActor> model_;
  Level fine_, coarse_;
  std::shared_ptr<const CortexPicture> detailed_;
  BrainLook look_ = BrainLook::model;
  double peel_mm_ = 0.0;
  bool is_visible_ = true, is_grey_ = false, is_quick_ = false;
};

}  // namespace facenav::scene
