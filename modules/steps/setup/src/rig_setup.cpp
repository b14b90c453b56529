#include "facenav/setup/rig_setup.h"

#include <atomic>
#include <deque>
#include <mutex>
#include <thread>

#include "facenav/core/error.h"
#include "setup_steps.h"

namespace facenav::steps {

struct RigSetup::Implementation {
  Implementation(std::unique_ptr<capture::FrameSource> cameras, const SetupOptions& options,
                 SetupMethods methods)
      : source(std::move(cameras)),
        steps(options, std::move(methods), {source->rig().width_px, source->rig().height_px}),
        results(steps.results()) {}

  std::unique_ptr<capture::FrameSource> source;
  SetupSteps steps;  // used only by the thread

  mutable std::mutex mutex;  // guards all members below
  std::deque<std::function<void(SetupSteps&)>> orders;
  std::shared_ptr<const SetupView> view = std::make_shared<SetupView>();
  SetupSteps::Results results;
  std::atomic<bool> is_stopped{false};
  std::thread thread;

  void run();
  void order(std::function<void(SetupSteps&)> what) {
    const std::lock_guard lock(mutex);
    orders.push_back(std::move(what));
  }
  void obey();
  void publish(const SetupView& next);
};

void RigSetup::Implementation::obey() {
  std::deque<std::function<void(SetupSteps&)>> now;
  {
    const std::lock_guard lock(mutex);
    now.swap(orders);
  }
  for (const auto& what : now) what(steps);
}

void RigSetup::Implementation::publish(const SetupView& next) {
  auto shared = std::make_shared<const SetupView>(next);
  const std::lock_guard lock(mutex);
  view = std::move(shared);
  results = steps.results();
}

void RigSetup::Implementation::run() {
  SetupView last;
  try {
    while (!is_stopped) {
      const auto frame = source->next();
      if (!frame) throw Error("the cameras gave no more picture", "", "open them again");
      obey();
      last = steps.look(frame, [this](const SetupView& waiting) { publish(waiting); });
      publish(last);
    }
  } catch (const std::exception& error) {
    last.failure = last.sentence = error.what();
    last.is_done = false;
    publish(last);
  }
}

RigSetup::RigSetup(std::unique_ptr<capture::FrameSource> source, const SetupOptions& options,
                   SetupMethods methods)
    : implementation_(std::make_unique<Implementation>(std::move(source), options, std::move(methods))) {
  implementation_->thread = std::thread([this] { implementation_->run(); });
}

RigSetup::~RigSetup() {
  implementation_->is_stopped = true;
  implementation_->thread.join();
}

std::shared_ptr<const SetupView> RigSetup::latest() const {
  const std::lock_guard lock(implementation_->mutex);
  return implementation_->view;
}

void RigSetup::go(SetupStep step) {
  implementation_->order([step](SetupSteps& steps) { steps.go(step); });
}
void RigSetup::useBoard(const cameras::Board& board) {
  implementation_->order([board](SetupSteps& steps) { steps.useBoard(board); });
}
void RigSetup::finishViews() {
  implementation_->order([](SetupSteps& steps) { steps.finishViews(); });
}
void RigSetup::takeMoreViews() {
  implementation_->order([](SetupSteps& steps) { steps.takeMoreViews(); });
}
void RigSetup::repeatViews() {
  implementation_->order([](SetupSteps& steps) { steps.repeatViews(); });
}
void RigSetup::useCoil(const coil_tracking::CoilModel& coil) {
  implementation_->order([coil](SetupSteps& steps) { steps.useCoil(coil); });
}
void RigSetup::startPivots() {
  implementation_->order([](SetupSteps& steps) { steps.startPivots(); });
}
void RigSetup::startJig(const coil_tracking::CoilModel& jig) {
  implementation_->order([jig](SetupSteps& steps) { steps.startJig(jig); });
}
void RigSetup::startWave() {
  implementation_->order([](SetupSteps& steps) { steps.startWave(); });
}

std::optional<cameras::StereoRig> RigSetup::rig() const {
  const std::lock_guard lock(implementation_->mutex);
  return implementation_->results.rig;
}

std::optional<capture::RigUncertainty_mm> RigSetup::uncertainty() const {
  const std::lock_guard lock(implementation_->mutex);
  return implementation_->results.uncertainty;
}

std::optional<health::RigVerification> RigSetup::verification() const {
  const std::lock_guard lock(implementation_->mutex);
  return implementation_->results.verification;
}

std::optional<coil_tracking::CoilCalibration> RigSetup::coilCalibration() const {
  const std::lock_guard lock(implementation_->mutex);
  return implementation_->results.coil;
}

std::optional<std::array<double, 2>> RigSetup::rowTimes_s() const {
  const std::lock_guard lock(implementation_->mutex);
  return implementation_->results.row_times_s;
}

}  // namespace facenav::steps
