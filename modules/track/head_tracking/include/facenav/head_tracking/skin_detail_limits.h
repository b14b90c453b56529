#pragma once
// SkinDetailLimits: when the fine detail under a fitted pose is the patient's (see skin_detail.h). A wider
// limit may let another person's face pass.

#include "facenav/core/setting.h"

namespace facenav::head_tracking {

struct SkinDetailLimits {
  static constexpr const char* kModule = "head_tracking";
  static constexpr const char* kSubject = "fine detail of the skin";

  double detail_decides = 0.62;
  double detail_least_agreed = 0.73;
  double detail_most_agreed = 1.25;
  double detail_sigmas = 3.0;
  double detail_plainly_else = 0.5;

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor(kRoom("detail_decides", 0.1, 1, "1",
                  "agreement, of what both cameras agree on, that divides the patient from others"),
            self.detail_decides);
    visitor(kBand("detail_least_agreed", 0.1, 1, "1",
                  "least agreement of both cameras that is taken; beyond, the noise is not as expected"),
            self.detail_least_agreed);
    visitor(kBand("detail_most_agreed", 1, 3, "1", "largest agreement of both cameras that is taken"),
            self.detail_most_agreed);
    visitor(kChance("detail_sigmas", 1, 10, "1", "standard errors on either side before it is decided"),
            self.detail_sigmas);
    visitor(kNotRecorded("detail_plainly_else", 0, 1, "1",
                         "patches below this share of the expected correlation show a hand, a mask, hair"),
            self.detail_plainly_else);
  }

 private:
  static constexpr Evidence kRoom{
      Origin::fitted,
      "halfway between own and others in the virtual room: three heads, one dark, three rigs: patient 0.80 "
      "to 0.99 (24 poses), others -0.06 to 0.34 (24); no other heads held out; films of another renderer "
      "were tracked as before"};
  static constexpr Evidence kBand{
      Origin::chosen, "origin not recorded; the agreement of both cameras is clamped to this band"};
  static constexpr Evidence kChance{Origin::physics, "tails of the normal distribution"};
  static constexpr Evidence kNotRecorded{Origin::chosen, "origin not recorded"};
};

}  // namespace facenav::head_tracking
