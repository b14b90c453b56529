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
  Timestamp captured;  // capture time of the left image
  /// Delay of the right image after the left one, by the cameras' own time stamps, s; nullopt: unknown.
  std::optional<double> right_late_s = std::nullopt;
  /// Reason as text why there are no pictures: a live camera is away. Empty: there are pictures.
  std::string absence = {};
  /// Reason as text why no pose of these pictures may be shown: the source detected that its cameras no
  /// longer fit their calibration. Empty: no known reason.
  std::string rig_fault = {};
};

}  // namespace facenav::cameras
