#pragma once
// BullsEye: where the coil is from the target, seen along the coil into the head. The target is the fixed
// centre; the coil's cross moves as the coil does and must come to the centre. The stroke from the cross
// shows the tilt (1 mm a degree), the tick on the rim the twist. Screen axes: up = the handle's prolongation
// (+y of Coil), and, since one looks along +z, the coil's +x points to the left. A grey, empty dial when
// there are no values.

#include <memory>
#include <optional>

#include "facenav/core/rgb_image.h"
#include "facenav/guidance/guidance.h"

class vtkRenderer;
class vtkRenderWindow;

namespace facenav::scene {

class BullsEye {
 public:
  BullsEye();
  ~BullsEye();
  BullsEye(const BullsEye&) = delete;
  BullsEye& operator=(const BullsEye&) = delete;

  void setTolerance(const guidance::Tolerance& tolerance);
  /// Values beyond the dial's edge (20 mm) are drawn at the edge.
  void set(const guidance::GuidanceState& guidance);
  /// For a picture of this size: the whole dial fits, also into a narrow one.
  void fit(int width_px, int height_px);
  vtkRenderer* renderer() const;
  RgbImage render(int width_px, int height_px);

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace facenav::scene
