#include "facenav/session/drift_watchdog.h"

#include <algorithm>
#include <cmath>
#include <thread>

#include "facenav/core/error.h"
#include "facenav/core/latest_value.h"

#ifdef __linux__
#include <sys/resource.h>
#endif

namespace facenav::session {
namespace {

constexpr int kDriftedForAlarm = 2;  // checks in a row

struct Question {
  std::shared_ptr<const stereo::StereoFrame> frame;
  RigidTransform<Camera, Mri> camera_T_mri;
};

/// The calling thread gets a tenth of a processor that others want, too: a frame never waits for it.
void giveWay() {
#ifdef __linux__
  setpriority(PRIO_PROCESS, 0, 10);  // 0: this thread alone
#endif
}

}  // namespace

struct DriftWatchdog::Worker {
  explicit Worker(Measure m) : measure(std::move(m)), thread([this] { run(); }) {}
  ~Worker() {
    questions.close();
    thread.join();
  }
  void run() {
    giveWay();
    while (!questions.isClosed()) {
      const auto question = questions.take(std::chrono::milliseconds(200));
      if (!question || questions.isClosed()) continue;
      answers.publish(std::make_shared<Answer>(
          Answer{question->frame->captured.s, measure(*question->frame, question->camera_T_mri)}));
    }
  }
  Measure measure;
  LatestValue<Question> questions;
  LatestValue<Answer> answers;
  std::thread thread;  // last: starts when the others stand
};

DriftWatchdog::DriftWatchdog(Measure measure, Mode mode) : measure_(std::move(measure)) {
  FACENAV_EXPECT(bool(measure_), "something must measure");
  if (mode == Mode::own_thread) worker_ = std::make_unique<Worker>(measure_);
}

DriftWatchdog::~DriftWatchdog() = default;

bool DriftWatchdog::isDue(double captured_s) const {
  if (is_busy_) return false;
  if (!asked_s_) return true;
  const double waited_s = std::abs(captured_s - *asked_s_);  // a recording may start again
  return waited_s >= (was_lost_ ? kRecheck_s : interval_s_);
}

void DriftWatchdog::take(const Answer& answer) {
  is_busy_ = false;
  finding_ = answer.finding;
  using Verdict = DriftFinding::Verdict;
  if (finding_.verdict == Verdict::drifted) ++drifted_in_row_;
  if (finding_.verdict == Verdict::agrees) drifted_in_row_ = 0, is_alarmed_ = false;
  if (drifted_in_row_ >= kDriftedForAlarm) is_alarmed_ = true;
  interval_s_ = drifted_in_row_ > 0 || is_alarmed_ ? kRecheck_s : kInterval_s;
}

void DriftWatchdog::add(std::shared_ptr<const stereo::StereoFrame> frame,
                        const std::optional<RigidTransform<Camera, Mri>>& camera_T_mri) {
  FACENAV_EXPECT(frame != nullptr, "a frame is needed");
  const double now_s = frame->captured.s;
  if (pending_ && std::abs(now_s - pending_->captured_s) >= kAnswer_s) {
    take(*pending_);
    pending_.reset();
  }
  if (worker_ && is_busy_)
    if (const auto answer = worker_->answers.take(std::chrono::milliseconds(0))) take(*answer);
  if (!camera_T_mri) {
    was_lost_ = true;
    return;
  }
  if (!isDue(now_s)) return;
  is_busy_ = true, was_lost_ = false, asked_s_ = now_s;
  if (worker_)
    worker_->questions.publish(std::make_shared<Question>(Question{std::move(frame), *camera_T_mri}));
  else
    pending_ = Answer{now_s, measure_(*frame, *camera_T_mri)};
}

}  // namespace facenav::session
