#pragma once
// SkinTexture: the patient's complexion as an albedo map around the head (cylinder about the vertical axis
// through the head's centre), with the portrait's face laid on by landmarks (thin-plate spline, Bookstein
// 1989).

#include <Eigen/Core>
#include <opencv2/core.hpp>
#include <vector>

namespace facenav::room {

class SkinTexture {
 public:
  /// `landmarks68_mm` on the skin, Mri; empty: plain skin everywhere.
  SkinTexture(const std::vector<Eigen::Vector3d>& landmarks68_mm, const Eigen::Vector3d& head_centre_mm);
  /// Albedo of bare skin without its finest grain; `lids`: 0 eyes open .. 1 closed.
  float at(const Eigen::Vector3d& p_mri_mm, float lids = 0.f) const;
  /// Map coordinates (mm along the cylinder, mm up) of a point.
  Eigen::Vector2d toMap(const Eigen::Vector3d& p_mri_mm) const;
  const cv::Mat& albedo() const { return albedo_; }

 private:
  Eigen::Vector3d centre_mm_;
  cv::Mat albedo_;  // float
  cv::Mat closed_;  // the same with the eyes closed
};

}  // namespace facenav::room
