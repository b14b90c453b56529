#pragma once
// StereoFrame: one pair of images taken at the same time, as recorded (not rectified).

#include <cstdint>
#include <opencv2/core.hpp>

#include "facenav/core/timestamp.h"

namespace facenav::cameras {

struct StereoFrame {
  cv::Mat left, right;  // 8-bit, 1 channel, H x W, both of the rig's size
  std::int64_t number = 0;
  Timestamp captured;
};

}  // namespace facenav::cameras
