#pragma once
// CoilSurroundings: a copy of both pictures round the marker, to detect that a later pair is the same picture
// under a new time. Two new pictures always differ, by sensor noise or motion.

#include <array>
#include <opencv2/core.hpp>

#include "facenav/cameras/stereo_frame.h"
#include "facenav/coil_tracking/coil_tracker.h"

namespace facenav::coil_tracking {

class CoilSurroundings {
 public:
  CoilSurroundings() = default;
  CoilSurroundings(const cameras::StereoFrame& frame, const health::SquareObservation& marker);
  /// True if either picture is bit for bit the same where the marker was. A moving coil has left that place.
  bool isRepeatedIn(const cameras::StereoFrame& frame) const;

 private:
  std::array<cv::Rect, 2> places_;
  std::array<cv::Mat, 2> pictures_;  // copies
};

}  // namespace facenav::coil_tracking
