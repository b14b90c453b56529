#include "facenav/setup/verified_cameras.h"

#include <atomic>
#include <mutex>
#include <thread>

#include "facenav/core/error.h"
#include "facenav/core/latest_value.h"
#include "facenav/core/log.h"

namespace facenav::steps {
namespace {

constexpr double kSaidUnclear_s = 6.0;  // time in which a person sits down and looks up
constexpr std::chrono::milliseconds kVerifyWait(100);
// Pause after the first result, so that a continued search (for a marker that is not in view) does not keep a
// core busy.
constexpr std::chrono::milliseconds kBetweenLater(100);

bool saysTheSame(const RigStart& a, const RigStart& b) {
  return a.state == b.state && a.by == b.by && a.isWithheld() == b.isWithheld();
}

}  // namespace

struct VerifiedCameras::Implementation {
  Implementation(std::unique_ptr<capture::FrameSource> source, RigStartCheck start_check,
                 std::string repair_words, Told teller)
      : cameras(std::move(source)),
        check(std::move(start_check)),
        repair(std::move(repair_words)),
        told(std::move(teller)) {
    standing.publish(std::make_shared<RigStart>(check.result()));
  }

  std::unique_ptr<capture::FrameSource> cameras;
  RigStartCheck check;  // used only by the thread
  const std::string repair;
  const Told told;
  LatestValue<cameras::StereoFrame> newest;
  LatestValue<RigStart> standing;
  std::atomic<bool> is_stopped{false}, has_told{false};
  std::thread thread;

  void run();
  void judge(const cameras::StereoFrame& frame, double since_s);
  void tell(const RigStart& now);
};

void VerifiedCameras::Implementation::tell(const RigStart& now) {
  standing.publish(std::make_shared<const RigStart>(now));
  has_told = true;
  if (told) told(now);
}

void VerifiedCameras::Implementation::judge(const cameras::StereoFrame& frame, double since_s) {
  check.add(frame);
  const RigStart now = check.result();
  if (!has_told) {
    if (now.by != RigStart::By::nothing || since_s > kSaidUnclear_s) tell(now);
  } else if (!saysTheSame(now, *standing.latest())) {
    tell(now);
  }
}

/// Runs the check. If it fails, the rig is unclear and the cameras continue.
void VerifiedCameras::Implementation::run() {
  std::optional<double> first_s;
  try {
    while (!is_stopped && !check.isDone()) {
      const auto frame = newest.take(kVerifyWait);
      if (!frame) continue;
      if (!first_s) first_s = frame->captured.s;
      judge(*frame, frame->captured.s - *first_s);
      if (has_told) std::this_thread::sleep_for(kBetweenLater);
    }
  } catch (const std::exception& error) {
    logWarning(std::string("the cameras could not be verified: ") + error.what());
  }
}

VerifiedCameras::VerifiedCameras(std::unique_ptr<capture::FrameSource> cameras, RigStartCheck check,
                                 std::string repair, Told told)
    : implementation_(std::make_unique<Implementation>(std::move(cameras), std::move(check),
                                                       std::move(repair), std::move(told))) {
  implementation_->thread = std::thread([this] { implementation_->run(); });
}

VerifiedCameras::~VerifiedCameras() {
  implementation_->is_stopped = true;
  implementation_->newest.close();
  implementation_->thread.join();
  if (!implementation_->has_told) implementation_->tell(implementation_->check.result());
}

const cameras::StereoRig& VerifiedCameras::rig() const { return implementation_->cameras->rig(); }

std::shared_ptr<const cameras::StereoFrame> VerifiedCameras::next() {
  auto frame = implementation_->cameras->next();
  if (!frame) return frame;
  implementation_->newest.publish(frame);
  const auto now = standing();
  if (!now->isWithheld()) return frame;
  auto doubted = std::make_shared<cameras::StereoFrame>(*frame);
  doubted->rig_fault = now->words() + (implementation_->repair.empty() ? "" : "; " + implementation_->repair);
  return doubted;
}

std::optional<std::int64_t> VerifiedCameras::frameCount() const {
  return implementation_->cameras->frameCount();
}

bool VerifiedCameras::isFromFiles() const { return implementation_->cameras->isFromFiles(); }

std::string VerifiedCameras::missingPairs() const { return implementation_->cameras->missingPairs(); }

std::vector<std::string> VerifiedCameras::cautions() const { return implementation_->cameras->cautions(); }

std::shared_ptr<const RigStart> VerifiedCameras::standing() const {
  return implementation_->standing.latest();
}

void VerifiedCameras::settle(double limit_s) {
  for (const double until_s = Timestamp::now().s + limit_s; Timestamp::now().s < until_s;)
    if (implementation_->has_told || !next()) return;
}

std::unique_ptr<VerifiedCameras> openVerified(const capture::CameraBackends& backends,
                                              const capture::NamedRig& rig, RigStartMethods methods,
                                              const std::string& repair, VerifiedCameras::Told told) {
  auto cameras = capture::openRig(backends, rig);
  RigStartCheck check(rig, std::move(methods));
  check.noteSettings(capture::changedSettings(*cameras), capture::restoredSettings(*cameras));
  return std::make_unique<VerifiedCameras>(std::move(cameras), std::move(check), repair, std::move(told));
}

void keepRigStart(const capture::RigStore& store, const std::string& name, const RigStart& found) {
  if (found.earlier && !isFault(found.state)) return;
  if (found.state == health::RigState::unclear && found.differs.empty()) {
    const auto last = store.read(name).last_check;
    if (last && last->state == toString(health::RigState::holds)) return;
  }
  store.note(name, capture::noteOfNow(toString(found.state), found.words()));
}

}  // namespace facenav::steps
