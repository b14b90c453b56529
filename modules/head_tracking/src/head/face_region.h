#pragma once
// FaceRegion: which pixels of the left reference image are face skin, and how far each part of it can be
// trusted to follow the skull: eyelids, pupils, lips and jaw move by themselves.

#include <Eigen/Core>
#include <opencv2/core.hpp>

#include "facenav/face/face_landmarks.h"

namespace facenav::head_tracking {

class FaceRegion {
 public:
  /// From the landmarks; from the cascade's box alone (an ellipse, all parts alike) where there are none.
  FaceRegion(const face::FaceLandmarks& face, cv::Size size);
  /// From the pixels at which the dense cloud was measured, all parts alike: for a face that no detector
  /// finds.
  FaceRegion(const std::vector<Eigen::Vector2f>& cloud_px, cv::Size size);

  bool contains(const Eigen::Vector2d& px) const;
  /// 0..1, prior trust in the skin at `px`.
  double rigidity(const Eigen::Vector2d& px) const;
  cv::Rect box() const { return box_; }

 private:
  cv::Mat1b rigidity_percent_;  // 0: not face
  cv::Rect box_;
};

}  // namespace facenav::head_tracking
