#pragma once
// SkinTexture: the patient's complexion as an albedo map around the head (cylinder about the vertical axis
// through the head's centre). The portrait's face is placed by landmarks (thin-plate spline, Bookstein 1989).

#include <Eigen/Core>
#include <cstdint>
#include <opencv2/core.hpp>
#include <vector>

namespace facenav::room {

/// Coarse complexion, fixed to the skin: blotches of ~4 mm and a few freckles of ~2 mm. A factor on the
/// albedo, one per vertex.
std::vector<float> complexion(const std::vector<Eigen::Vector3d>& skin_mm, std::uint64_t seed,
                              double contrast = 1.0);

class SkinTexture {
 public:
  /// Makes the texture. `landmarks68_mm` on the skin, Mri; empty: plain skin everywhere.
  /// `has_sides_exchanged`: the portrait is mirrored (another person's face).
  SkinTexture(const std::vector<Eigen::Vector3d>& landmarks68_mm, const Eigen::Vector3d& head_centre_mm,
              bool has_sides_exchanged = false);
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
