#include "facenav/setup/rig_setup.h"

#include <atomic>
#include <chrono>
#include <deque>
#include <mutex>
#include <thread>

#include "facenav/core/error.h"
#include "setup_steps.h"

namespace facenav::steps {
namespace {

constexpr std::chrono::milliseconds kFileRest(30);  // between two looks at a frame that stays

}  // namespace

struct RigSetup::Implementation {
  Implementation(std::unique_ptr<capture::FrameSource> cameras, const SetupOptions& options,
                 SetupMethods methods)
      : source(std::move(cameras)),
        steps(options, std::move(methods), {source->rig().width_px, source->rig().height_px}),
        results(steps.results()) {}

  std::unique_ptr<capture::FrameSource> source;
  SetupSteps steps;  // used only by the thread, as the next two
  std::int64_t frames_read = 0;
  bool has_ended = false;  // files: no pair is left

  mutable std::mutex mutex;  // guards all members below
  std::deque<std::function<void(SetupSteps&)>> orders;
  std::shared_ptr<const SetupView> view = std::make_shared<SetupView>();
  SetupSteps::Results results;
  std::atomic<bool> is_stopped{false};
  std::thread thread;

  void run();
  std::shared_ptr<const cameras::StereoFrame> read(const SetupView& last);
  void tellReading(SetupView& now) const;
  void order(std::function<void(SetupSteps&)> what) {
    const std::lock_guard lock(mutex);
    orders.push_back(std::move(what));
  }
  bool obey();
  void publish(const SetupView& next);
};

/// Carries out the orders; false if there are none.
bool RigSetup::Implementation::obey() {
  std::deque<std::function<void(SetupSteps&)>> now;
  {
    const std::lock_guard lock(mutex);
    now.swap(orders);
  }
  for (const auto& what : now) what(steps);
  return !now.empty();
}

void RigSetup::Implementation::publish(const SetupView& next) {
  auto shared = std::make_shared<const SetupView>(next);
  const std::lock_guard lock(mutex);
  view = std::move(shared);
  results = steps.results();
}

/// Returns the next frame. Files are read only as the step needs them, and stay at their last frame.
std::shared_ptr<const cameras::StereoFrame> RigSetup::Implementation::read(const SetupView& last) {
  const bool is_file = source->isFromFiles();
  if (is_file && last.frame && (has_ended || !steps.wantsFrame())) {
    std::this_thread::sleep_for(kFileRest);
    return last.frame;
  }
  auto frame = source->next();
  if (frame) {
    ++frames_read;
    return frame;
  }
  if (!is_file || !last.frame)
    throw Error(is_file ? "the two files have no pair of pictures" : "the cameras gave no more picture", "",
                is_file ? "choose others" : "open them again");
  has_ended = true;
  return last.frame;
}

/// Adds what was read of the files, and what they lack.
void RigSetup::Implementation::tellReading(SetupView& now) const {
  const std::string count = std::to_string(frames_read) + (frames_read == 1 ? " pair" : " pairs");
  now.lines.push_back({true, count + (has_ended ? " read: the files are at their end" : " read so far")});
  if (const std::string missing = source->missingPairs(); !missing.empty())
    now.lines.push_back({false, missing});
  if (has_ended && !now.is_done && steps.wantsFrame())
    now.sentence = "the files are at their end: " + now.sentence;
}

void RigSetup::Implementation::run() {
  SetupView last;
  try {
    while (!is_stopped) {
      const bool had_ended = has_ended;
      const auto frame = read(last);
      const bool is_again = last.frame && frame == last.frame;
      if (!obey() && is_again && has_ended == had_ended) continue;  // a file rests
      last = steps.look(frame, [this](const SetupView& waiting) { publish(waiting); });
      if (source->isFromFiles()) tellReading(last);
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
