#pragma once
// Face detection and the landmarks that start alignment and tracking without a click (Haar cascade + dlib's 68-point
// predictor where its model file is installed; the cascade alone otherwise).

#include <optional>
#include <vector>

#include "facenav/stereo/stereo_rig.h"

namespace facenav::tracking {

struct FaceLandmarks {
  cv::Rect face;                              // left or right image, px
  std::vector<Eigen::Vector2d> points68;      // the iBUG 68 points, px; empty where the model is not installed
};

class FaceDetector {
 public:
  virtual ~FaceDetector() = default;
  /// The largest face in an 8-bit grey image, or nothing. In-plane rotations up to about 45 degrees are tried.
  virtual std::optional<FaceLandmarks> detect(const cv::Mat& grey) const = 0;
};

/// Throws Error when the cascade file is not installed, saying which package holds it.
std::unique_ptr<FaceDetector> makeFaceDetector();

}  // namespace facenav::tracking
