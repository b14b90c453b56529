#pragma once
// StepLimits: epipolar error of the skin above which the two images are of different moments
// (src/recovery/sides.h).

#include "facenav/core/setting.h"

namespace facenav::head_tracking {

struct StepLimits {
  static constexpr const char* kModule = "head_tracking";
  static constexpr const char* kSubject = "two images of two moments";

  int step_fewest = 40;
  double step_harm_mm = 0.4;
  double step_sigmas = 1.5;
  double step_sure_alone = 2.0;
  double step_one_fault_s = 1.0;
  double step_clear_px = 1.0;
  double step_clear_sigmas = 8.0;
  double step_clear_spread_px = 2.0;

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor(kNotRecorded("step_fewest", 10, 1000, "1", "points in both cameras for an answer"),
            self.step_fewest);
    visitor(kHarm("step_harm_mm", 0.1, 5, "mm",
                  "error of the depth by a motion between the exposures from which on they are two moments"),
            self.step_harm_mm);
    visitor(kPairs("step_sigmas", 0.5, 10, "1", "standard errors beyond it"), self.step_sigmas);
    visitor(kPairs("step_sure_alone", 1, 10, "1", "times the limit: one answer is enough"),
            self.step_sure_alone);
    visitor(kNotRecorded("step_one_fault_s", 0.05, 10, "s", "between two answers that are judged together"),
            self.step_one_fault_s);
    visitor(kNotRecorded("step_clear_px", 0.2, 10, "px",
                         "offset that is clear on a face not known to be the patient's"),
            self.step_clear_px);
    visitor(kNotRecorded("step_clear_sigmas", 1, 30, "1", "standard errors beyond it"),
            self.step_clear_sigmas);
    visitor(
        kNotRecorded("step_clear_spread_px", 0.2, 10, "px", "spread above which such an offset is chance"),
        self.step_clear_spread_px);
  }

 private:
  static constexpr Evidence kHarm{Origin::fitted,
                                  "chosen on two real people (three rigs, five moments): in step 0.33 mm at "
                                  "most, two moments 1 mm apart 0.3 to 0.5 mm, 4 mm apart 0.9 mm and more; "
                                  "nobody held out"};
  static constexpr Evidence kPairs{Origin::fitted,
                                   "on 60 pairs of one real person (three rigs, five moments): in step 0.13 "
                                   "px at most, 0.21 where both images are shifted by 13 px; two moments 1 "
                                   "mm apart 0.23 to 0.50 px, all others 2 px and more; none held out"};
  static constexpr Evidence kNotRecorded{Origin::chosen,
                                         "origin not recorded; in development on one real person"};
};

}  // namespace facenav::head_tracking
