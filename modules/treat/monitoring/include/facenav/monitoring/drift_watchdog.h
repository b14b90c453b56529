#pragma once
// DriftWatchdog: runs drift_check.h about once a second in parallel with the tracking. It raises an alarm
// when two checks in a row find the face elsewhere than tracked; the alarm lasts until a check agrees. Live,
// it uses its own thread and never delays a frame. In recordings it measures inline and applies the result
// after a fixed delay, so that the same recording always gives the same poses.

#include <functional>
#include <memory>

#include "facenav/core/later_answer.h"
#include "facenav/monitoring/drift_check.h"

namespace facenav::monitoring {

/// Checks that must agree before they decide.
constexpr int kLeastAgreeing = 2;

class DriftWatchdog {
 public:
  using Measure = std::function<DriftFinding(const cameras::StereoFrame& frame,
                                             const RigidTransform<Camera, Mri>& camera_T_mri)>;
  struct Question {
    std::shared_ptr<const cameras::StereoFrame> frame;
    RigidTransform<Camera, Mri> camera_T_mri;
  };
  struct Answer {
    double captured_s;
    DriftFinding finding;
  };
  using Checks = LaterAnswer<Question, Answer>;
  using Mode = Checks::Mode;

  static constexpr double kInterval_s = 1.0;
  static constexpr double kRecheck_s = 0.25;  // after an uncertain result, or after the head was lost

  DriftWatchdog(Measure measure, Mode mode);

  /// Adds a frame, with the tracked pose, shown or not, or without a pose where the head is lost. Call it for
  /// each frame.
  void add(std::shared_ptr<const cameras::StereoFrame> frame,
           const std::optional<RigidTransform<Camera, Mri>>& camera_T_mri);
  bool isAlarmed() const { return is_alarmed_; }
  /// Result of the last check.
  const DriftFinding& finding() const { return finding_; }

 private:
  static Checks::Work workOf(Measure measure);
  void take(const Answer& answer);
  bool isDue(double captured_s) const;

  Checks checks_;
  std::optional<double> asked_s_;   // capture time of the last measured frame
  double interval_s_ = kRecheck_s;  // until the next measurement
  bool was_lost_ = false, is_alarmed_ = false;
  int drifted_in_row_ = 0;
  DriftFinding finding_;
};

}  // namespace facenav::monitoring
