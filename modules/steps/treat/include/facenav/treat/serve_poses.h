#pragma once
// SERVE: tracks head and coil in live cameras, or in a recording played as if it were live, and sends the
// poses to other programs. No session is logged: a session of a case sends them too (TreatRecordingRequest).

#include <functional>
#include <memory>

#include "facenav/capture/frame_source.h"
#include "facenav/treat/live_orders.h"
#include "facenav/treat/live_outputs.h"
#include "facenav/treat/track_recording.h"

namespace facenav::steps {

struct ServeRequest {
  TrackRequest track;  // its recording is empty with live cameras, which have no case
  /// Opens live cameras; empty: the recording is played.
  std::function<std::unique_ptr<capture::FrameSource>()> openCameras = nullptr;
  double seconds = 0;  // 0: until the recording's end, or until cancelled
  double speed = 1.0;  // of a recording, relative to real time
  int passes = 1;      // through the recording, alternately forwards and backwards; 0: without end
  std::shared_ptr<LiveOutputs> outputs;
  /// What clients may ask; null: nothing. "stop" sends every pose as lost until "start"; a pulse goes on to
  /// the outputs; targets are judged by the case.
  LiveOrders* orders = nullptr;
  /// Called with what clients sent; may be null.
  std::function<void(const OrderNews&)> tell = nullptr;
};

struct ServeOutcome {
  std::int64_t frames = 0;    // number of the last frame, plus one
  std::uint64_t dropped = 0;  // frames that tracking did not get to
};

/// Tracks and sends until the end, or until `monitor` is cancelled. Throws Error as trackRecording does.
ServeOutcome servePoses(const Registrations& methods, const ServeRequest& request, TaskMonitor& monitor);

}  // namespace facenav::steps
