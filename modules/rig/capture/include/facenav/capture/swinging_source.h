#pragma once
// SwingingSource: a short recording played forwards and backwards in turn, so that nothing jumps. A rehearsal
// or a test can then last as long as needed. Frame numbers increase without end, and times continue by the
// recording's steps.

#include <memory>

#include "facenav/capture/recording.h"

namespace facenav::capture {

/// Index (0 = first frame) of the recording's frame that is shown as frame `number`.
std::int64_t swungFrame(std::int64_t number, std::int64_t frames_of_recording);
/// Makes the source. `passes`: number of passes through the recording, in either direction; 0: without end.
/// Throws the same Errors as makeSource.
std::unique_ptr<FrameSource> makeSwingingSource(const Recording& recording, int passes);

}  // namespace facenav::capture
