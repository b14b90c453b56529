#pragma once
// RegistrationCheck: is the MRI still aligned with the face? Asked for by a person, or before a session goes
// on: for about two seconds it measures the face densely against the scalp at the tracked pose
// (drift_check.h), some five times, and says what most of the measurements say. It uses fresh frames and its
// own thread, and never delays a frame; the watchdog goes on beside it.

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
  /// agrees: passed. unknown: too little of the face was measured.
  DriftFinding::Verdict verdict = DriftFinding::Verdict::unknown;
  double shift_mm = 0, turn_deg = 0;  // medians of the measurements that say something
  int measurements = 0;               // these
  int number = 0;                     // of the check in its session, from 1

  bool hasPassed() const { return verdict == DriftFinding::Verdict::agrees; }
};
/// "passed: face 0.4 mm and 0.2 deg from where the MRI's is, 5 measurements".
std::string inWords(const RegistrationFinding& finding);
/// What most measurements say: at least `kLeastAgreeing` that agree and more than have drifted, or the other
/// way round.
RegistrationFinding findingOf(const std::vector<DriftFinding>& measurements);
constexpr int kLeastAgreeing = 2;

class RegistrationCheck {
 public:
  RegistrationCheck(DriftWatchdog::Measure measure, DriftWatchdog::Mode mode);

  /// Begins; once more, if one runs.
  void begin();
  bool isRunning() const { return is_running_; }
  /// Call for each frame: with the tracked pose, shown or not, or without a pose where the head is lost.
  void add(std::shared_ptr<const cameras::StereoFrame> frame,
           const std::optional<RigidTransform<Camera, Mri>>& camera_T_mri);
  /// The finding, once, when the check is done.
  std::optional<RegistrationFinding> take();

 private:
  static constexpr std::size_t kEnough = 5;  // measurements that say something

  DriftWatchdog::Checks checks_;
  bool is_running_ = false;
  int number_ = 0;
  std::optional<double> begun_s_, asked_s_;  // by the frames' times
  std::vector<DriftFinding> measured_;
  std::optional<RegistrationFinding> done_;
};

}  // namespace facenav::monitoring
