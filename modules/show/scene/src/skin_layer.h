#pragma once
// SkinLayer: the translucent scalp, with larger triangles while the view moves. Private to scene.

#include "actors.h"

namespace facenav::scene {

class SkinLayer {
 public:
  SkinLayer(vtkRenderer* renderer, vtkLinearTransform* head) : renderer_(renderer), head_(head) {}

  void set(const surface::TriangleMesh& scalp);
  /// Sets the look. `opacity`: value at the rim.
  void setLook(bool is_visible, bool is_quick, bool is_grey, double opacity);
  /// The actor drawn now, or null.
  vtkActor* shown() const;

 private:
  vtkRenderer* renderer_;
  vtkLinearTransform* head_;
  vtkSmartPointer<vtkActor> fine_, coarse_;
};

}  // namespace facenav::scene
