#pragma once
// BullsEye: the position of the coil relative to the target, seen along the coil into the head. The target is
// the fixed centre. The coil's cross moves with the coil and must reach the centre. The line from the cross
// shows the tilt (1 mm per degree), the tick on the rim the twist. Screen axes: up = the handle's
// prolongation (+y of Coil); the view is along +z, so the coil's +x points to the left. Without values the
// dial is grey and empty.

#include <memory>
#include <optional>

#include "facenav/core/rgb_image.h"
#include "facenav/guidance/guidance.h"
#include "facenav/scene/palette.h"

class vtkRenderer;
class vtkRenderWindow;

namespace facenav::scene {

/// Colours of the dial. The defaults are those of all pictures.
struct DialColours {
  palette::Rgb around = palette::kPanel, dial = palette::kBackground, lines = palette::kLine,
               coil = palette::kText, on_target = palette::kBlue, adjust = palette::kOrange;
};

class BullsEye {
 public:
  BullsEye();
  ~BullsEye();
  BullsEye(const BullsEye&) = delete;
  BullsEye& operator=(const BullsEye&) = delete;

  void setColours(const DialColours& colours);
  void setTolerance(const guidance::Tolerance& tolerance);
  /// Draws the values. Values beyond the dial's range (20 mm) are drawn at the edge.
  void set(const guidance::GuidanceState& guidance);
  /// Fits the whole dial into a picture of this size, also a narrow one.
  void fit(int width_px, int height_px);
  vtkRenderer* renderer() const;
  RgbImage render(int width_px, int height_px);

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace facenav::scene
