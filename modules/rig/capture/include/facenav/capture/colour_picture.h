#pragma once
// The left picture of a recording in colour, for point clouds that people view. Frames are grey everywhere
// else.

#include "facenav/capture/recording.h"

namespace facenav::capture {

/// The left picture of a frame, 8-bit blue, green, red. Empty if it is grey or comes from a video. Throws
/// Error if the recording has no such frame.
cv::Mat leftColour(const Recording& recording, std::int64_t frame);
/// The left picture of the capture's plain pair; empty if there is no capture.
cv::Mat captureColour(const Recording& recording);

}  // namespace facenav::capture
