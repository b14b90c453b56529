#pragma once
// CoilSliceLayer: the two slices along the coil's axis in the 3-D scene, along its handle and across it. They
// are drawn over the head, so that no surface hides them. Private to scene.

#include <array>
#include <memory>

#include "actors.h"
#include "facenav/scene/coil_slices.h"

class vtkImageData;

namespace facenav::scene {

class CoilSliceLayer {
 public:
  /// Builds the layer. `on_top`: the renderer over the head's; `coil`: places Coil in it.
  CoilSliceLayer(vtkRenderer* on_top, vtkLinearTransform* coil);

  /// Sets the MRI; null: no slices.
  void setVolume(std::shared_ptr<const volume::Volume> mri);
  /// Sets the coil's pose; nothing: no coil and no slices from now on.
  void follow(const std::optional<RigidTransform<Mri, Coil>>& mri_T_coil);
  /// Cuts the MRI at the coil's pose, once per pose; call it before drawing. Takes about a millisecond.
  void cut();
  bool isShown() const;

 private:
  void cutOne(std::size_t which);

  std::shared_ptr<const volume::Volume> mri_;
  std::optional<RigidTransform<Mri, Coil>> mri_T_coil_;
  bool is_outdated_ = false;
  double black_ = 0, white_ = 1;  // usual window
  std::array<vtkSmartPointer<vtkImageData>, 2> images_;
  std::array<vtkSmartPointer<vtkActor>, 2> actors_;
};

}  // namespace facenav::scene
