#pragma once
// RegistrationCheck: tests whether the MRI is still aligned with the face, on request of a person or before a
// session continues. For about two seconds it measures the face densely against the scalp at the tracked pose
// (drift_check.h), some five times, and returns the majority's result. It uses fresh frames and its own
// thread, and never delays a frame; the watchdog continues beside it.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "facenav/core/setting.h"
#include "facenav/monitoring/drift_watchdog.h"

namespace facenav::monitoring {

struct RegistrationCheckRules {
  static constexpr const char* kModule = "monitoring";
  static constexpr const char* kSubject = "re-check of the registration";

  double check_s = 2.0, ask_after_min = 20;

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor(kLength("check_s", 0.5, 30, "s", "how long a re-check measures the face"), self.check_s);
    visitor(kAsk("ask_after_min", 1, 240, "min", "a re-check is asked for after this time"),
            self.ask_after_min);
  }

  static constexpr Evidence kLength{
      Origin::chosen,
      "a person holds still so long; one measurement takes some 40 ms, so five fit "
      "in on a busy machine"};
  static constexpr Evidence kAsk{
      Origin::chosen,
      "about half of a session of 3000 pulses at 10 Hz; what drifts faster, the watchdog "
      "finds within seconds"};
};

struct RegistrationFinding {
  /// agrees: passed. unknown: too few points on the face.
  DriftFinding::Verdict verdict = DriftFinding::Verdict::unknown;
  double shift_mm = 0, turn_deg = 0;  // medians of the measurements that are not unknown
  int measurements = 0;               // number of those
  int number = 0;                     // number of the check in its session, from 1

  bool hasPassed() const { return verdict == DriftFinding::Verdict::agrees; }
};
/// Returns "passed: face 0.4 mm and 0.2 deg from where the MRI's is, 5 measurements".
std::string inWords(const RegistrationFinding& finding);
/// Majority of the measurements: at least `kLeastAgreeing` that agree and more than have drifted, or the
/// reverse.
RegistrationFinding findingOf(const std::vector<DriftFinding>& measurements);

class RegistrationCheck {
 public:
  RegistrationCheck(DriftWatchdog::Measure measure, DriftWatchdog::Mode mode);

  /// Begins a check; restarts a running one.
  void begin();
  bool isRunning() const { return is_running_; }
  /// Adds a frame, with the tracked pose, shown or not, or without a pose where the head is lost. Call it for
  /// each frame.
  void add(std::shared_ptr<const cameras::StereoFrame> frame,
           const std::optional<RigidTransform<Camera, Mri>>& camera_T_mri);
  /// Returns the finding, once, when the check is done.
  std::optional<RegistrationFinding> take();

 private:
  static constexpr std::size_t kEnough = 5;  // measurements that are not unknown

  DriftWatchdog::Checks checks_;
  bool is_running_ = false;
  int number_ = 0;
  std::optional<double> begun_s_, asked_s_;  // by the frames' times
  std::vector<DriftFinding> measured_;
  std::optional<RegistrationFinding> done_;
};

}  // namespace facenav::monitoring
