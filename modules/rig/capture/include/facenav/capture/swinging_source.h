#pragma once
// SwingingSource: a short recording played forwards and backwards in turn, so that nothing jumps: a rehearsal
// or a test lasts as long as it needs. Frames are numbered on and on, and their times go on by the steps of
// the recording's own.

#include <memory>

#include "facenav/capture/recording.h"

namespace facenav::capture {

/// The index (0 = the recording's first frame) of the recording's frame that is shown as frame `number`.
std::int64_t swungFrame(std::int64_t number, std::int64_t frames_of_recording);
/// `passes`: through the recording, in either direction; 0: without end. Throws the same Errors as
/// makeSource.
std::unique_ptr<FrameSource> makeSwingingSource(const Recording& recording, int passes);

}  // namespace facenav::capture
