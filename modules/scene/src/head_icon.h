#pragma once
// HeadIcon: a small head with the letters R L A P S in a corner of the 3-D view; it turns with the view.
// Private to scene.

#include <vtkNew.h>
#include <vtkRenderer.h>

namespace facenav::scene {

class HeadIcon {
 public:
  HeadIcon();
  vtkRenderer* renderer() { return renderer_; }
  /// Turns the icon to the orientation of the head in `main`. The head's axes are `world_R_mri` (columns
  /// right, anterior, superior).
  void follow(vtkRenderer* main, const double world_R_mri[3][3]);

 private:
  vtkNew<vtkRenderer> renderer_;
};

}  // namespace facenav::scene
