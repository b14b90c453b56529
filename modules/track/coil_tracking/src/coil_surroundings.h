#pragma once
// CoilSurroundings: the part of both pictures round the marker, kept to see that a later pair shows the very
// same picture under a new time. Sensor noise makes two pictures differ, and so does motion.

#include <array>
#include <opencv2/core.hpp>

#include "facenav/cameras/stereo_frame.h"
#include "facenav/coil_tracking/coil_tracker.h"

namespace facenav::coil_tracking {

class CoilSurroundings {
 public:
  CoilSurroundings() = default;
  CoilSurroundings(const cameras::StereoFrame& frame, const health::SquareObservation& marker);
  /// Either picture is the same bit for bit where the marker was. A moving coil is not there any more.
  bool isRepeatedIn(const cameras::StereoFrame& frame) const;

 private:
  std::array<cv::Rect, 2> places_;
  std::array<cv::Mat, 2> pictures_;  // copies
};

}  // namespace facenav::coil_tracking
