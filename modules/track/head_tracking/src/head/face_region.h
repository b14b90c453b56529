#pragma once
// FaceRegion: which pixels of the left reference image are face skin, and how rigidly each part follows the
// skull. Eyelids, pupils, lips and jaw move by themselves.

#include <Eigen/Core>
#include <opencv2/core.hpp>

#include "facenav/face/face_landmarks.h"

namespace facenav::head_tracking {

class FaceRegion {
 public:
  /// Makes it from the landmarks. Without landmarks: an ellipse in the cascade's box, all parts alike.
  FaceRegion(const face::FaceLandmarks& face, cv::Size size);
  /// Makes it from the pixels of the dense cloud, all parts alike, for a face that no detector finds.
  FaceRegion(const std::vector<Eigen::Vector2f>& cloud_px, cv::Size size);

  bool contains(const Eigen::Vector2d& px) const;
  /// Prior weight of the skin at `px`, 0..1: how rigidly it follows the skull.
  double rigidity(const Eigen::Vector2d& px) const;
  cv::Rect box() const { return box_; }
  /// Part of the face whose errors of light and shape are treated as one, 0 .. kPartColumns * kPartRows - 1.
  int partAt(const Eigen::Vector2d& px) const;
  static constexpr int kPartColumns = 5, kPartRows = 6;

 private:
  cv::Mat1b rigidity_percent_;  // per pixel; 0: not face
  cv::Rect box_;
};

}  // namespace facenav::head_tracking
