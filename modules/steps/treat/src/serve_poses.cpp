#include "facenav/treat/serve_poses.h"

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
  session.follow([outputs = request.outputs](const auto& state) { outputs->publish(state); });
  session.start();
  while (!session.hasEnded() && (request.seconds <= 0 || session.elapsed_s() < request.seconds)) {
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
