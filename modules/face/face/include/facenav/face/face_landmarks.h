#pragma once
// Detects a face and its landmarks, the start of alignment and tracking without a click. The detector is
// dlib's (histograms of gradients, Dalal & Triggs 2005). It adds dlib's 68 landmarks if the model file is
// installed. The paper's detector is in lab/peers.

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <vector>

#include "facenav/cameras/stereo_rig.h"

namespace facenav::face {

class LandmarkModel;

struct FaceLandmarks {
  cv::Rect face;                          // in px of the given image, forehead to lower lip
  std::vector<Eigen::Vector2d> points68;  // the iBUG 68 points, px; empty if the model is not installed
  double roll_rad = 0.0;                  // in-plane roll of the face, clockwise on the image
  double score = 0.0;                     // of the detector; larger: surer
};

/// The skin from chin to forehead, a convex polygon in px of the image. Without landmarks: an ellipse in the
/// face's box. The box itself holds clothes and walls too.
std::vector<cv::Point> outlineOf(const FaceLandmarks& face);

class FaceDetector {
 public:
  virtual ~FaceDetector() = default;
  /// The surest face in an 8-bit grey image, or nothing. Tries in-plane rotations up to about 45 degrees,
  /// then those of cameras mounted on their side or upside down.
  virtual std::optional<FaceLandmarks> detect(const cv::Mat& grey) const = 0;
  /// All that may be a face, the surest first. The other camera decides which are (findStereoFace).
  virtual std::vector<FaceLandmarks> detectAll(const cv::Mat& grey) const {
    const auto one = detect(grey);
    return one ? std::vector<FaceLandmarks>{*one} : std::vector<FaceLandmarks>{};
  }
  /// The face near its last position, size and roll; a few times faster than detect().
  virtual std::optional<FaceLandmarks> detectNear(const cv::Mat& grey, const FaceLandmarks& last) const = 0;
  /// The surest face with roll `roll_rad` (within some 15 degrees), anywhere; much faster than detect().
  virtual std::optional<FaceLandmarks> detectAtRoll(const cv::Mat& grey, double roll_rad) const = 0;
  /// The landmarks of one face as read from several boxes around it. They scatter where light or expression
  /// mislead the landmark model; the other camera decides which are right (findStereoFace).
  virtual std::vector<FaceLandmarks> readings(const cv::Mat& /*grey*/, const FaceLandmarks& found) const {
    return {found};
  }
};

std::unique_ptr<FaceDetector> makeFaceDetector();
/// Makes a detector that uses a shared landmark model (100 MB).
std::unique_ptr<FaceDetector> makeFaceDetector(std::shared_ptr<const LandmarkModel> landmarks);

}  // namespace facenav::face
