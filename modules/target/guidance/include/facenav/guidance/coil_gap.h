#pragma once
// The gap between the coil's contact face and the head, and the field that it costs. The gap is measured in
// two ways that share only the coil's pose: from the MRI's skin at the head's pose, and from the live surface
// (skin or hair) that both cameras measure beside the coil. Pure functions.

#include <optional>
#include <string>

#include "facenav/core/setting.h"

namespace facenav::guidance {

struct FieldByGap {
  static constexpr const char* kModule = "guidance";
  static constexpr const char* kSubject = "field lost by the coil's gap";
  double lost_a_mm_pct = 4;

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor(kComputed("lost_a_mm_pct", 0, 10, "%", "field lost for each mm between coil and scalp"),
            self.lost_a_mm_pct);
  }
  static constexpr Evidence kComputed{
      Origin::physics,
      "field of a figure-of-eight coil of 42 dipoles over a sphere of 92 mm, 20 mm deep: 80.66 V/m in "
      "contact, "
      "53.46 V/m at a gap of 10 mm, that is 4.03 % a mm (4.2 % for the first one)"};
};
/// Share of the field lost by the gap, in % of the field of a coil that touches the skin; 0 for a gap of 0 or
/// less.
double fieldLost_pct(double gap_mm);

/// Height of the live surface above the MRI's skin beside the coil.
struct LiveSurface {
  double above_skin_mm = 0;  // > 0: outside the MRI's skin
  double sigma_mm = 0;       // its standard error, alignment not included
};

struct CoilGap {
  std::optional<double> by_poses_mm;  // contact face's centre above the MRI's skin
  std::optional<LiveSurface> live;
  double alignment_sigma_mm = 0;  // standard error of the head's pose along the skin's normal; 0: unknown
  std::string unseen;             // why `live` is absent; empty: not measured yet, or present

  /// Height of the contact face's centre above the live surface.
  std::optional<double> byStereo_mm() const;
  /// Standard error of the difference of both measurements.
  double apartSigma_mm() const;
  /// True if both differ by more than two standard errors (95 % limit).
  bool disagrees() const;
};
/// Returns "the live surface lies 4.1 mm outside the MRI's skin (error 0.7): hair, or the alignment is off";
/// empty unless disagrees().
std::string disagreementInWords(const CoilGap& gap);

}  // namespace facenav::guidance
