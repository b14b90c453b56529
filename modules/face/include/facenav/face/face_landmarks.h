#pragma once
// Face detection and the landmarks that start alignment and tracking without a click (Haar cascade + dlib's
// 68-point predictor where its model file is installed; the cascade alone otherwise). Paper, section 4
// (Viola-Jones, OpenCV).

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <vector>

#include "facenav/cameras/stereo_rig.h"

namespace facenav::face {

class LandmarkModel;

struct FaceLandmarks {
  cv::Rect face;                          // left or right image, px
  std::vector<Eigen::Vector2d> points68;  // the iBUG 68 points, px; empty where the model is not installed
  double roll_rad = 0.0;  // in-plane rotation at which the face was found, clockwise on the image
};

class FaceDetector {
 public:
  virtual ~FaceDetector() = default;
  /// The largest face in an 8-bit grey image, or nothing. In-plane rotations up to about 45 degrees are
  /// tried, then cameras mounted on their side or upside down.
  virtual std::optional<FaceLandmarks> detect(const cv::Mat& grey) const = 0;
  /// The face near where it was seen last (position, size and roll), a few times faster than detect().
  virtual std::optional<FaceLandmarks> detectNear(const cv::Mat& grey, const FaceLandmarks& last) const = 0;
  /// The largest face rolled by `roll_rad` (within some 15 degrees), anywhere; a fraction of detect()'s time.
  virtual std::optional<FaceLandmarks> detectAtRoll(const cv::Mat& grey, double roll_rad) const = 0;
};

/// Throws Error when the cascade file is not installed, saying which package holds it.
std::unique_ptr<FaceDetector> makeFaceDetector();
/// The same with a landmark model that others use too (it takes 100 MB).
std::unique_ptr<FaceDetector> makeFaceDetector(std::shared_ptr<const LandmarkModel> landmarks);

}  // namespace facenav::face
