#pragma once
// Robust point-to-plane fit of the face cloud to the skin (Chen and Medioni 1992) by Gauss-Newton on SE(3).
// The loss is one-sided while coarse: points outside the skin (hair, clothes) are let go earlier than points
// inside, which no camera can see. State: mri_T_camera.

#include <optional>
#include <vector>

#include "facenav/geometry/rotation.h"
#include "skin_field.h"

namespace facenav::registration {

struct FitStage {
  double inside_mm, outside_mm;  // residuals beyond have no weight
  int iterations;
  bool is_exact;  // distance to the triangles instead of the nearest vertex's plane
};

/// One point of the cloud against the skin.
struct PointMatch {
  double residual_mm = 0.0;  // along the skin's normal, positive outside
  Eigen::Vector3d normal_mri = Eigen::Vector3d::Zero(), at_mri_mm = Eigen::Vector3d::Zero();
  int vertex = -1;
  bool is_valid = false;  // a counterpart exists: within the scan, skin that faces the camera
};

class PoseFitter {
 public:
  /// `mirror_x_mm`: fits the skin mirrored at that sagittal plane instead. `weights`: one per point or empty.
  PoseFitter(const SkinField& skin, PointCloud<Camera> cloud, std::optional<double> mirror_x_mm = {});

  const PointCloud<Camera>& cloud() const { return cloud_; }
  void setWeights(std::vector<double> weights) { weights_ = std::move(weights); }

  std::vector<PointMatch> match(const Eigen::Isometry3d& mri_T_camera, bool is_exact) const;
  Eigen::Isometry3d fit(Eigen::Isometry3d mri_T_camera, const FitStage& stage) const;
  /// Mean truncated squared residual over all points, mm^2: points without counterpart cost the truncation,
  /// points deep inside the head 1.3 times (the neck bends).
  double cost(const Eigen::Isometry3d& mri_T_camera, double truncation_mm) const;
  /// The point about which increments rotate: the middle of the skin.
  const Eigen::Vector3d& pivot_mri_mm() const { return pivot_; }

 private:
  PointMatch matchOne(std::size_t point, const Eigen::Isometry3d& mri_T_camera, bool is_exact) const;

  const SkinField& skin_;
  PointCloud<Camera> cloud_;
  std::optional<double> mirror_x_mm_;
  std::vector<double> weights_;
  Eigen::Vector3d pivot_;
};

/// Tukey's biweight: 1 at 0, 0 from `limit` on.
double tukeyWeight(double residual, double limit);

}  // namespace facenav::registration
