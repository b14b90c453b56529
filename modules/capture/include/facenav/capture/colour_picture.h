#pragma once
// The left picture of a recording in colour. Frames are grey everywhere else; colour is for people who look
// at a cloud.

#include "facenav/capture/recording.h"

namespace facenav::capture {

/// The left picture of a frame, 8-bit blue, green, red. Empty where it is grey, or lies in a video. Throws
/// Error where the recording has no such frame.
cv::Mat leftColour(const Recording& recording, std::int64_t frame);
/// The same of the capture's plain pair; empty where there is no capture.
cv::Mat captureColour(const Recording& recording);

}  // namespace facenav::capture
