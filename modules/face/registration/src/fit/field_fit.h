#pragma once
// FieldFitter: robust point-to-plane fit of the face cloud to the scalp's distance field by Gauss-Newton on
// SE(3) (Chen and Medioni 1992; on a distance field: Fitzgibbon 2003). In the coarse stages the loss is
// one-sided: points outside the skin (hair, clothes, a hand) lose their weight earlier than points inside,
// which no camera can see. State: mri_T_camera.

#include <limits>
#include <vector>

#include "facenav/geometry/rotation.h"
#include "facenav/registration/scalp_field.h"
#include "field/point_kernel.h"

namespace facenav::registration {

/// Residuals up to so many standard deviations of the measurement are always fitted: a normal distribution
/// has 99.7 % there.
constexpr float kNoiseReach = 3.0f;

struct FitStage {
  float inside_mm, outside_mm;  // larger residuals have no weight
  int iterations;
  bool is_fine;              // fine or coarse grid
  float settled_mm = 5e-4f;  // convergence: limit of the last shift, and of the arc at a radius of 100 mm
};

/// A point of the cloud compared with the skin.
struct PointMatch {
  float residual_mm = std::numeric_limits<float>::max();  // along the skin's normal, positive outside
  Eigen::Vector3f normal_mri = Eigen::Vector3f::Zero(), at_mri_mm = Eigen::Vector3f::Zero();
  bool is_valid = false;  // has a counterpart: within the scan, on skin that faces the camera
};

class FieldFitter {
 public:
  FieldFitter(const ScalpField& scalp, const PointCloud<Camera>& cloud, const std::vector<int>& points);

  std::size_t size() const { return count_; }
  /// One weight per point, 0..1, or empty.
  void setWeights(std::vector<float> weights);

  Eigen::Isometry3d fit(Eigen::Isometry3d mri_T_camera, const FitStage& stage) const;
  std::vector<PointMatch> match(const Eigen::Isometry3d& mri_T_camera) const;
  /// Indices of the points within `reach_mm` of the skin, by the coarse grid.
  std::vector<int> within(const Eigen::Isometry3d& mri_T_camera, double reach_mm) const;
  /// Mean truncated squared residual over all points, mm^2. A point without counterpart costs the truncation
  /// limit, a point deep inside the head 1.3 times that (the neck bends).
  double cost(const Eigen::Isometry3d& mri_T_camera, double truncation_mm) const;

 private:
  point::Points points() const;
  /// Calls visit(block, index of its first point) for each block.
  template <class Visitor>
  void measure(const Eigen::Isometry3d& mri_T_camera, bool is_fine, Visitor&& visit) const;

  const ScalpField& scalp_;
  std::vector<float> points_[3], normals_[3];  // x, y, z in whole blocks
  std::vector<float> weights_;
  Eigen::Vector3f pivot_;  // the head's middle, centre of rotation of the increments
  std::size_t count_;
};

/// Tukey's biweight: 1 at 0, 0 from `limit` on.
inline float tukeyWeight(float residual, float limit) {
  const float u = residual / limit, v = 1.0f - u * u;
  return v > 0.0f ? v * v : 0.0f;
}

/// exp(w) (q - pivot) + pivot + v, applied after `pose`.
Eigen::Isometry3d increment(const Vector6d& xi, const Eigen::Vector3d& pivot_mm,
                            const Eigen::Isometry3d& pose);

/// True if the poses differ by more than `rotation_rad`, or by more than `distance_mm` at `pivot_mri_mm`.
bool areDistinct(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b, const Eigen::Vector3d& pivot_mri_mm,
                 double rotation_rad, double distance_mm);

}  // namespace facenav::registration
