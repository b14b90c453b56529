#pragma once
// HeadIcon: a small head with the letters R L A P S in a corner of the 3-D view; it turns with the view.
// Private to scene.

#include <vtkBillboardTextActor3D.h>
#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <vector>

namespace facenav::scene {

class HeadIcon {
 public:
  HeadIcon();
  vtkRenderer* renderer() { return renderer_; }
  /// Sets the letters' size, as a factor of the usual one.
  void setTextScale(double scale);
  /// Turns the icon to the orientation of the head in `main`. The head's axes are `world_R_mri` (columns
  /// right, anterior, superior).
  void follow(vtkRenderer* main, const double world_R_mri[3][3]);

 private:
  void addLetter(const char* letter, double x, double y, double z);

  vtkNew<vtkRenderer> renderer_;
  std::vector<vtkSmartPointer<vtkBillboardTextActor3D>> letters_;
};

}  // namespace facenav::scene
