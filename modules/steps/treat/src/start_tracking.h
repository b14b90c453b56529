#pragma once
// How a recording starts to be tracked: from the pictures of its alignment, or at the first frame in which
// the face is found and can be tracked.

#include <memory>
#include <optional>
#include <string>

#include "facenav/capture/frame_source.h"
#include "facenav/session/navigator.h"
#include "facenav/treat/track_recording.h"

namespace facenav::steps {

struct StartedTracking {
  std::unique_ptr<session::Navigator> navigator;
  bool is_aligned = false;                    // poses of the head are in the MRI's frame
  std::optional<AlignmentOutcome> alignment;  // if the case was aligned in this run
  std::string why_no_head;                    // empty: the head is tracked; else only the coil is
};

/// Throws Error if the case cannot be aligned. Without an alignment to make it does not throw for want of a
/// face: then only the coil is tracked, and `why_no_head` says why.
StartedTracking startTracking(const Registrations& methods, const TrackRequest& request,
                              const capture::Recording& recording, const coil_tracking::CoilModel& coil,
                              TaskMonitor& monitor);

/// Starts with live cameras, without a case, at the first frame in which the face is found. It waits for the
/// face until `monitor` is cancelled, and then throws Cancelled.
StartedTracking startAtLiveFace(const Registrations& methods, const TrackRequest& request,
                                capture::FrameSource& source, const coil_tracking::CoilModel& coil,
                                TaskMonitor& monitor);

}  // namespace facenav::steps
