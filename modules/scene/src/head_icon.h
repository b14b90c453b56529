#pragma once
// HeadIcon: a small mannequin that turns with the view, lettered R L A P S, in a corner of the 3-D view.
// Private.

#include <vtkNew.h>
#include <vtkRenderer.h>

namespace facenav::scene {

class HeadIcon {
 public:
  HeadIcon();
  vtkRenderer* renderer() { return renderer_; }
  /// Turns the icon as `main` sees the head (whose axes are `world_R_mri`, columns right, anterior,
  /// superior).
  void follow(vtkRenderer* main, const double world_R_mri[3][3]);

 private:
  vtkNew<vtkRenderer> renderer_;
};

}  // namespace facenav::scene
