#include "facenav/session/session.h"

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "facenav/core/log.h"

namespace facenav::session {
namespace {

struct ArrivedFrame {
  std::shared_ptr<const cameras::StereoFrame> frame;
  Timestamp arrived;
};

}  // namespace

struct Session::Implementation {
  std::unique_ptr<capture::FrameSource> source;
  std::unique_ptr<Navigator> navigator;
  SessionOptions options;
  std::unique_ptr<Recorder> recorder;
  LatestValue<ArrivedFrame> frames;
  std::shared_ptr<LatestValue<NavigationState>> states = std::make_shared<LatestValue<NavigationState>>();
  std::atomic<bool> is_stopping{false}, has_ended{false}, is_source_empty{false};
  mutable std::mutex mutex;  // guards the members below, up to `end`
  std::condition_variable stop_requested;
  std::optional<std::optional<ChosenTarget>> new_target, new_second_target;
  std::optional<coil_tracking::CoilModel> new_coil;
  std::optional<bool> wanted_check;  // value: withhold the poses until the check passes
  std::optional<bool> is_judged_wrong;
  std::optional<std::function<void(const NavigationState&)>> new_listener;
  std::string failure;
  std::optional<Timestamp> started, ended;
  SessionEnd end = SessionEnd::none;
  std::thread capture_thread, tracking_thread;
  std::function<void(const NavigationState&)> listener;  // of the tracking thread

  void capture();
  void takeListener();
  void track();
  void publishFailure();
  void requestStop();
  void noteEnd();
  void waitUntil(double steady_s);
  template <class Body>
  void guarded(Body body);
};

/// Runs `body` and turns any exception into a state that the consumer shows.
template <class Body>
void Session::Implementation::guarded(Body body) {
  try {
    body();
  } catch (const std::exception& error) {
    logWarning(std::string("session stopped: ") + error.what());
    std::lock_guard lock(mutex);
    if (failure.empty()) failure = error.what();
  }
}

/// Publishes the failure. Called last on the tracking thread, so that no pose follows it.
void Session::Implementation::publishFailure() {
  takeListener();
  std::lock_guard lock(mutex);
  if (failure.empty()) return;
  const auto last = states->latest();
  NavigationState state = last ? *last : NavigationState{};
  state.failure = failure;
  state.arrived = Timestamp::now();
  const auto last_state = std::make_shared<NavigationState>(blanked(state, LostReason::camera));
  states->publish(last_state);
  if (listener) listener(*last_state);
}

void Session::Implementation::takeListener() {
  std::lock_guard lock(mutex);
  if (new_listener) listener = std::move(*new_listener);
  new_listener.reset();
}

/// Records why the session ended. Called before the states are closed, so that a consumer can ask then.
void Session::Implementation::noteEnd() {
  std::lock_guard lock(mutex);
  ended = Timestamp::now();
  end = !failure.empty() ? SessionEnd::fault : is_source_empty ? SessionEnd::source : SessionEnd::stop;
  has_ended = true;
}

void Session::Implementation::requestStop() {
  {
    std::lock_guard lock(mutex);
    is_stopping = true;
  }
  stop_requested.notify_all();
  frames.close();
}

void Session::Implementation::waitUntil(double steady_s) {
  std::unique_lock lock(mutex);
  const double wait_s = steady_s - Timestamp::now().s;
  if (wait_s > 0)
    stop_requested.wait_for(lock, std::chrono::duration<double>(wait_s),
                            [this] { return is_stopping.load(); });
}

void Session::Implementation::capture() {
  std::optional<double> first_s;
  const double begin_s = Timestamp::now().s;
  while (!is_stopping) {
    auto frame = source->next();
    if (!frame) {
      is_source_empty = true;
      break;
    }
    if (options.is_paced) {
      if (!first_s) first_s = frame->captured.s;
      waitUntil(begin_s + (frame->captured.s - *first_s) / options.speed);
      if (is_stopping) break;
    }
    if (recorder && frame->absence.empty()) recorder->add(frame);
    frames.publish(std::make_shared<ArrivedFrame>(ArrivedFrame{frame, Timestamp::now()}));
  }
}

void Session::Implementation::track() {
  while (!is_stopping) {
    auto next = frames.take(std::chrono::milliseconds(50));
    if (!next) {
      if (frames.isClosed()) break;
      continue;
    }
    {
      std::lock_guard lock(mutex);
      if (new_target) navigator->setTarget(std::move(*new_target));
      new_target.reset();
      if (new_second_target) navigator->setSecondTarget(std::move(*new_second_target));
      new_second_target.reset();
      if (new_coil) navigator->setCoil(*new_coil);
      new_coil.reset();
      if (wanted_check) navigator->checkRegistration(*wanted_check);
      wanted_check.reset();
      if (is_judged_wrong) navigator->judgeAlignment(*is_judged_wrong);
    }
    takeListener();
    auto state = std::make_shared<NavigationState>(navigator->process(next->frame));
    state->arrived = next->arrived;
    state->taken = options.is_paced ? next->arrived : state->captured;  // live cameras use the steady clock
    state->latency_ms = (Timestamp::now() - next->arrived) * 1e3;
    state->dropped = frames.dropped();
    if (listener) listener(*state);
    states->publish(std::move(state));
  }
}

Session::Session(std::unique_ptr<capture::FrameSource> source, std::unique_ptr<Navigator> navigator,
                 const SessionOptions& options, std::unique_ptr<Recorder> recorder)
    : implementation_(std::make_unique<Implementation>()) {
  implementation_->source = std::move(source);
  implementation_->navigator = std::move(navigator);
  implementation_->options = options;
  implementation_->recorder = std::move(recorder);
}

Session::~Session() { stop(); }

void Session::start() {
  auto& s = *implementation_;
  FACENAV_EXPECT(!s.capture_thread.joinable(), "a session starts once");
  {
    std::lock_guard lock(s.mutex);
    s.started = Timestamp::now();
  }
  s.capture_thread = std::thread([&s] {
    s.guarded([&s] { s.capture(); });
    s.frames.close();
  });
  s.tracking_thread = std::thread([&s] {
    s.guarded([&s] { s.track(); });
    s.requestStop();  // a fault in tracking also ends the capture
    s.publishFailure();
    s.noteEnd();
    s.states->close();
  });
}

void Session::stop() {
  auto& s = *implementation_;
  s.requestStop();
  for (std::thread* thread : {&s.capture_thread, &s.tracking_thread})
    if (thread->joinable()) thread->join();
  if (s.recorder) s.recorder->close();
}

std::shared_ptr<const NavigationState> Session::latest() const {
  auto state = implementation_->states->latest();
  if (!state) return std::make_shared<NavigationState>(blanked({}, LostReason::stale));
  // Factor on the age limit for pictures that arrive late, from a queue. Allows for a camera's usual delay,
  // below 0.1 s.
  constexpr double kMostLate = 2.0;  // for a paced recording `taken` is its arrival
  const double limit_s = implementation_->options.age_limit_s;
  const Timestamp now = Timestamp::now();
  const bool is_old = now - state->arrived > limit_s || now - state->taken > kMostLate * limit_s;
  if (!is_old || !state->failure.empty()) return state;
  return std::make_shared<NavigationState>(blanked(*state, LostReason::stale));
}

std::shared_ptr<const NavigationState> Session::take(std::chrono::milliseconds timeout) {
  return implementation_->states->take(timeout);
}

std::shared_ptr<const LatestValue<NavigationState>> Session::states() const {
  return implementation_->states;
}

bool Session::hasEnded() const { return implementation_->has_ended; }

SessionEnd Session::end() const {
  std::lock_guard lock(implementation_->mutex);
  return implementation_->end;
}

double Session::elapsed_s() const {
  std::lock_guard lock(implementation_->mutex);
  if (!implementation_->started) return 0.0;
  return implementation_->ended.value_or(Timestamp::now()) - *implementation_->started;
}

void Session::setTarget(std::optional<ChosenTarget> target) {
  std::lock_guard lock(implementation_->mutex);
  implementation_->new_target = std::move(target);
}

void Session::setSecondTarget(std::optional<ChosenTarget> target) {
  std::lock_guard lock(implementation_->mutex);
  implementation_->new_second_target = std::move(target);
}

void Session::setCoil(const coil_tracking::CoilModel& coil) {
  std::lock_guard lock(implementation_->mutex);
  implementation_->new_coil = coil;
}

void Session::follow(std::function<void(const NavigationState&)> listener) {
  std::lock_guard lock(implementation_->mutex);
  implementation_->new_listener = std::move(listener);
}

void Session::checkRegistration(bool is_withheld_until) {
  std::lock_guard lock(implementation_->mutex);
  implementation_->wanted_check = is_withheld_until || implementation_->wanted_check.value_or(false);
}

void Session::judgeAlignment(bool is_wrong) {
  std::lock_guard lock(implementation_->mutex);
  implementation_->is_judged_wrong = is_wrong;
}

std::vector<casefile::StoredKeyFrame> Session::learntKeyFrames() const {
  FACENAV_EXPECT(!implementation_->tracking_thread.joinable(), "the session has stopped");
  return implementation_->navigator->learntKeyFrames();
}

const Recorder* Session::recorder() const { return implementation_->recorder.get(); }

}  // namespace facenav::session
