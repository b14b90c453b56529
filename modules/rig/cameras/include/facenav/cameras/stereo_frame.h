#pragma once
// StereoFrame: one pair of images taken at the same time, as recorded (not rectified).

#include <cstdint>
#include <opencv2/core.hpp>
#include <optional>
#include <string>

#include "facenav/core/timestamp.h"

namespace facenav::cameras {

struct StereoFrame {
  cv::Mat left, right;  // 8-bit, 1 channel, H x W, both of the rig's size
  std::int64_t number = 0;
  Timestamp captured;  // of the left image
  /// How much later the right image was taken, by the cameras' own time stamps, s. Absent: unknown.
  std::optional<double> right_late_s = std::nullopt;
  /// Why there are no pictures, in words: a live camera is away. Empty: there are.
  std::string absence = {};
  /// Why no pose of these pictures may be shown, in words: the source knows that its cameras no longer fit
  /// their calibration. Empty: it knows of no reason.
  std::string rig_fault = {};
};

}  // namespace facenav::cameras
