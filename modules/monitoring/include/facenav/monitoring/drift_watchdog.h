#pragma once
// DriftWatchdog: has the face measured (drift_check.h) about once a second beside the tracking, and raises an
// alarm when twice in a row it does not lie where it is tracked; the alarm lasts until the next check that
// agrees. Live it works in a thread of its own and never holds a frame up. In recordings it measures in line,
// and its answer counts from a fixed time later on, so that the same recording always gives the same poses.

#include <functional>
#include <memory>

#include "facenav/core/later_answer.h"
#include "facenav/monitoring/drift_check.h"

namespace facenav::monitoring {

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
  static constexpr double kRecheck_s = 0.25;  // after a doubtful answer, or after the head was lost
  static constexpr double kAnswer_s = 0.1;    // in line: when the answer counts, after the frame's capture

  DriftWatchdog(Measure measure, Mode mode);

  /// Each frame: with the pose as tracked, whether it is shown or not; without one where the head is lost.
  void add(std::shared_ptr<const cameras::StereoFrame> frame,
           const std::optional<RigidTransform<Camera, Mri>>& camera_T_mri);
  bool isAlarmed() const { return is_alarmed_; }
  /// The last answer.
  const DriftFinding& finding() const { return finding_; }

 private:
  static Checks::Work workOf(Measure measure);
  void take(const Answer& answer);
  bool isDue(double captured_s) const;

  Checks checks_;
  std::optional<double> asked_s_;   // capture time of the frame last measured
  double interval_s_ = kRecheck_s;  // until the next
  bool was_lost_ = false, is_alarmed_ = false;
  int drifted_in_row_ = 0;
  DriftFinding finding_;
};

}  // namespace facenav::monitoring
