#pragma once
// The coil's plate on the head. The contact face is a flat plate with the coil's own outline; it touches the
// scalp and never passes through it; hair keeps it off by the gap. The axis stays on its aim (the cortex
// point, or a place of the scalp). The plate is tangent to the skin under its centre where that brings the
// centre within `flat_mm` of the skin. Elsewhere (a hollow, an ear or the nape under a wing) it tilts, by the
// least angle that brings its centre as near to the skin as pressing along the axis would.
// Hair and skin give way by millimetres in fact; the skin is taken as rigid here.

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
/// Two discs of 104 mm side by side, 93 mm apart: the housing of a common figure-of-eight coil of 70 mm.
CoilPlate figureOfEight();
/// "contact_outline_mm" of coil.json: a list of [x, y], three at least; figureOfEight() where it is absent.
/// Throws Error naming file and key, also for an outline that does not surround the coil's centre.
CoilPlate readPlate(const std::filesystem::path& coil_json);

struct PlateRest {
  static constexpr const char* kModule = "guidance";
  static constexpr const char* kSubject = "coil's plate on the head";
  double patch_mm = 8;   // sigma of the patch whose mean normal is the skin's normal
  double flat_mm = 0.5;  // centre above the skin up to which the plate lies flat, untilted
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

/// How a plate stands on the skin at a target's pose, hair left out.
struct PlateContact {
  double lift_mm = 0;                // its centre above the skin, along the axis
  double tilt_rad = 0;               // against the skin's normal under its centre
  double through_mm = 0;             // how far skin lies above the plate; 0 for a pose made here
  std::vector<Point<Mri>> touching;  // vertices within 0.05 mm of the plate

  bool isTangent() const { return lift_mm <= 0.5 && tilt_rad < 2.0 * kRadPerDeg && through_mm < 0.05; }
};
PlateContact contactOf(const Target& target, const surface::ScalpSurface& scalp, const CoilPlate& plate);

enum class Aim { cortex_point, scalp_point };
/// The target with its plate resting on the head, its axis through the aim. Name, note, gap and handle angle
/// stay; scalp_point is where the axis meets the skin. Throws Error where the axis meets no skin.
Target restOnHead(const Target& target, const surface::ScalpSurface& scalp, const CoilPlate& plate,
                  Aim aim = Aim::cortex_point);
/// The target with its plate on the head and its axis as it is, as after a turn or another gap. Rests it
/// anew, as restOnHead, where its centre would come further from the skin than before, or than `flat_mm`.
Target settleOnHead(const Target& target, const surface::ScalpSurface& scalp, const CoilPlate& plate);

}  // namespace facenav::guidance
