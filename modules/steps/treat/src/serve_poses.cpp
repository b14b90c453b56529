#include "facenav/treat/serve_poses.h"

#include <atomic>
#include <thread>

#include "facenav/capture/recording.h"
#include "facenav/capture/swinging_source.h"
#include "facenav/core/error.h"
#include "facenav/core/log.h"
#include "facenav/core/number_text.h"
#include "facenav/session/session.h"
#include "start_tracking.h"

namespace facenav::steps {
namespace {

constexpr std::chrono::milliseconds kLookAtServing(20);

struct Serving {
  std::unique_ptr<capture::FrameSource> source;
  StartedTracking tracking;
};

Serving startServing(const Registrations& methods, const ServeRequest& request, TaskMonitor& monitor) {
  TrackRequest track = request.track;
  const auto coil =
      track.coil_file ? coil_tracking::readCoil(*track.coil_file) : coil_tracking::defaultCoil();
  track.pace = head_tracking::Pace::live;
  Serving serving;
  if (request.openCameras) {
    serving.source = request.openCameras();
    serving.tracking = startAtLiveFace(methods, track, *serving.source, coil, monitor);
    return serving;
  }
  const auto recording = capture::openRecording(track.recording);
  serving.source = request.passes == 1 ? capture::makeSource(recording)
                                       : capture::makeSwingingSource(recording, request.passes);
  serving.tracking = startTracking(methods, track, recording, coil, monitor);
  if (!serving.tracking.why_no_head.empty())
    logWarning("the head is not tracked: " + serving.tracking.why_no_head);
  return serving;
}

/// Obeys clients where no session runs: they can hold back the poses, and pass on pulses.
class ServedOrders {
 public:
  explicit ServedOrders(const ServeRequest& request)
      : orders_(request.orders), outputs_(request.outputs), tell_(request.tell) {
    if (request.track.case_folder) store_ = casefile::CaseStore::open(*request.track.case_folder);
  }
  void look() {
    if (!orders_) return;
    const OrderReceiver receiver{[this](const links::LiveOrder& order) { return obey(order); }};
    for (const auto& news : orders_->obey(receiver, store_ ? &*store_ : nullptr))
      if (tell_) tell_(news);
  }
  /// Sends a state; every pose in it is lost while a client has stopped them. Thread-safe.
  void publish(const session::NavigationState& state) const {
    if (is_stopped_) return outputs_->publish(session::blanked(state, LostReason::stale));
    outputs_->publish(state);
  }

 private:
  std::string obey(const links::LiveOrder& order) {
    if (order.name == "pulse") {
      outputs_->publish(pulseOf(order));
      return "a pulse was given";
    }
    const bool stops = order.name == "stop";
    if (is_stopped_.exchange(stops) == stops) return stops ? "poses were stopped already" : "poses were sent";
    return stops ? "no poses until start" : "poses are sent again";
  }

  LiveOrders* orders_;
  std::shared_ptr<LiveOutputs> outputs_;
  std::function<void(const OrderNews&)> tell_;
  std::optional<casefile::CaseStore> store_;
  std::atomic<bool> is_stopped_{false};
};

std::string servingWords(const LiveOutputs& outputs, const session::NavigationState& state) {
  const std::string loss = session::lossInWords(state);
  return formatted("%s; %d connected", loss.empty() ? "head and coil tracked" : loss.c_str(),
                   int(outputs.receivers().size()));
}

}  // namespace

ServeOutcome servePoses(const Registrations& methods, const ServeRequest& request, TaskMonitor& monitor) {
  auto serving = startServing(methods, request, monitor);
  session::SessionOptions options;
  options.is_paced = !request.openCameras;
  options.speed = request.speed;
  session::Session session(std::move(serving.source), std::move(serving.tracking.navigator), options);
  if (request.track.case_folder) request.outputs->setCase(*request.track.case_folder);
  const auto served = std::make_shared<ServedOrders>(request);
  session.follow([served](const auto& state) { served->publish(state); });
  session.start();
  while (!session.hasEnded() && (request.seconds <= 0 || session.elapsed_s() < request.seconds)) {
    served->look();
    try {
      monitor.report(servingWords(*request.outputs, *session.latest()),
                     request.seconds > 0 ? session.elapsed_s() / request.seconds : -1.0);
    } catch (const Cancelled&) {  // the usual end
      break;
    }
    std::this_thread::sleep_for(kLookAtServing);
  }
  const auto last = session.latest();
  session.stop();
  if (!last->failure.empty()) throw Error(last->failure);
  return {last->frame + 1, last->dropped};
}

}  // namespace facenav::steps
