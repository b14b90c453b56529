#pragma once
// Rests the coil's contact plate on the head. The plate is flat, has the coil's own outline, touches the
// scalp and never passes through it; hair keeps it off by the gap. The coil's axis stays on its aim (the
// cortex point, or a point of the scalp). The plate is tangent to the skin under its centre where that brings
// the centre within `flat_mm` of the skin. Elsewhere (a hollow, an ear or the nape under a wing) it tilts by
// the smallest angle that brings its centre as near to the skin as pressing along the axis would. The skin is
// modelled as rigid; real hair and skin yield by millimetres.

#include <Eigen/Core>
#include <filesystem>
#include <vector>

#include "facenav/core/setting.h"
#include "facenav/geometry/rotation.h"
#include "facenav/guidance/target.h"

namespace facenav::guidance {

struct CoilPlate {
  std::vector<Eigen::Vector2d> outline_mm;  // closed polygon in Coil x and y
};
/// Outline of a common figure-of-eight coil of 70 mm: two discs of 104 mm, 93 mm apart.
CoilPlate figureOfEight();
/// Reads "contact_outline_mm" of coil.json: a list of at least three [x, y]. Returns figureOfEight() if the
/// key is absent. Throws Error naming file and key, also if the outline does not surround the coil's centre.
CoilPlate readPlate(const std::filesystem::path& coil_json);

struct PlateRest {
  static constexpr const char* kModule = "guidance";
  static constexpr const char* kSubject = "coil's plate on the head";
  double patch_mm = 8;   // sigma of the patch whose mean normal is the skin's normal
  double flat_mm = 0.5;  // largest height of the centre above the skin at which the plate stays untilted
  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor(kChosen("patch_mm", 2, 30, "mm", "patch of skin whose mean normal a coil is tangent to"),
            self.patch_mm);
    visitor(
        kChosen("flat_mm", 0.05, 5, "mm", "a plate whose centre is no further from the skin is not tilted"),
        self.flat_mm);
  }
  static constexpr Evidence kChosen{
      Origin::chosen,
      "by judgement: the skin of an MRI is rough by 0.1 to 0.3 mm, and a patch of "
      "this size yields under a pressed coil"};
};

/// Contact of a plate with the skin at a target's pose, hair not included.
struct PlateContact {
  double lift_mm = 0;                // height of its centre above the skin, along the axis
  double tilt_rad = 0;               // against the skin's normal under its centre
  double through_mm = 0;             // how far the skin passes through the plate; 0 for a pose computed here
  std::vector<Point<Mri>> touching;  // vertices within 0.05 mm of the plate

  bool isTangent() const { return lift_mm <= 0.5 && tilt_rad < 2.0 * kRadPerDeg && through_mm < 0.05; }
};
PlateContact contactOf(const Target& target, const surface::ScalpSurface& scalp, const CoilPlate& plate);

enum class Aim { cortex_point, scalp_point };
/// Returns the target with its plate resting on the head and its axis through the aim. Name, note, gap and
/// handle angle do not change; scalp_point becomes the axis' intersection with the skin. Throws Error where
/// the axis meets no skin.
Target restOnHead(const Target& target, const surface::ScalpSurface& scalp, const CoilPlate& plate,
                  Aim aim = Aim::cortex_point);
/// Returns the target with its plate on the head and its axis unchanged, for use after a turn or a change of
/// the gap. Calls restOnHead instead if the centre would lie further from the skin than before and than
/// `flat_mm`.
Target settleOnHead(const Target& target, const surface::ScalpSurface& scalp, const CoilPlate& plate);

/// Returns the target moved along the scalp by x and y (its own axes, mm), its plate resting on the head
/// there, over the place that movedAlongScalp gives. Gap, name and note do not change, nor does the cortex
/// point's place under the plate. The handle keeps its direction: its pose turns by the one
/// smallest rotation from the old axis to the new one, so rough skin cannot turn it step by step. Throws as
/// movedAlongScalp and restOnHead do.
Target movedOnHead(const Target& target, const surface::ScalpSurface& scalp, const CoilPlate& plate,
                   double x_mm, double y_mm);

}  // namespace facenav::guidance
