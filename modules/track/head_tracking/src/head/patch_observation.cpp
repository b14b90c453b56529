#include "patch_observation.h"

#include <Eigen/LU>
#include <cmath>

namespace facenav::head_tracking {
namespace {

constexpr double kCommonError_px =
    0.15;  // errors of shape and light common to both images, pixels of the level

// Displacement of the patch in camera c per displacement along the skin, in pixels of the left key image.
Eigen::Matrix2d alongSkin(const Patch& patch, int c) {
  Eigen::Matrix<double, 3, 2> tangents;
  tangents << patch.right_mm, patch.down_mm;
  return patch.view[std::size_t(c)].jacobian.rightCols<3>() * tangents;
}

// One half of an error belongs to the key frame; the other half grows if the view is foreshortened.
Eigen::Matrix2d grown(const Eigen::Matrix2d& error, const Eigen::Matrix2d& key_from_now) {
  return 0.5 * (error + key_from_now * error * key_from_now.transpose());
}

Eigen::Matrix2d commonError(const Patch& patch, int c, const PatchChange& change) {
  const double shading = shadingSigma(change.light_change, patch.normal_spread_rad);
  return kCommonError_px * kCommonError_px * Eigen::Matrix2d::Identity() +
         shading * shading * patch.view[std::size_t(c)].shading;
}

// Effect of an error of the patch's depth, which grows as the view turns away from the key frame's.
Eigen::Vector2d shownDepth_px(const Patch& patch, int c, const PatchChange& change) {
  const PatchView& view = patch.view[std::size_t(c)];
  return patch.depth_sigma_mm * view.jacobian.rightCols<3>() * (view.ray - change.ray[std::size_t(c)]);
}

}  // namespace

PatchObservation observedByOne(const Patch& patch, int c, const PatchChange& change) {
  const PatchView& view = patch.view[std::size_t(c)];
  const Eigen::Vector2d depth_px = shownDepth_px(patch, c, change);
  PatchObservation observation;
  observation.combine.block<2, 2>(0, 2 * c).setIdentity();
  observation.jacobian = view.jacobian;
  observation.covariance =
      grown(view.covariance + commonError(patch, c, change), change.key_from_now[std::size_t(c)]) +
      depth_px * depth_px.transpose();
  return observation;
}

bool canBePaired(const Patch& patch) {
  return patch.view[0].is_usable && patch.view[1].is_usable &&
         std::abs(alongSkin(patch, 0).determinant()) > kLeastArea &&
         std::abs(alongSkin(patch, 1).determinant()) > kLeastArea;
}

std::array<PatchObservation, 2> observedByBoth(const Patch& patch, const PatchChange& change) {
  std::array<Eigen::Matrix2d, 2> skin_from, own;
  std::array<Eigen::Matrix<double, 2, 6>, 2> jacobian;
  std::array<Eigen::Vector2d, 2> depth_px;
  for (int c = 0; c < 2; ++c) {
    const auto at = std::size_t(c);
    skin_from[at] = alongSkin(patch, c).inverse();
    own[at] =
        skin_from[at] * grown(patch.view[at].covariance, change.key_from_now[at]) * skin_from[at].transpose();
    jacobian[at] = skin_from[at] * patch.view[at].jacobian;
    depth_px[at] = skin_from[at] * shownDepth_px(patch, c, change);
  }
  // The mean is weighted by each camera's own errors, so that it is independent of the difference.
  const Eigen::Matrix2d sum_inverse = (own[0] + own[1]).inverse();
  const Eigen::Matrix2d share[2] = {own[1] * sum_inverse, own[0] * sum_inverse};
  std::array<PatchObservation, 2> observations;
  observations[0].combine << share[0] * skin_from[0], share[1] * skin_from[1];
  observations[0].jacobian = share[0] * jacobian[0] + share[1] * jacobian[1];
  const Eigen::Vector2d depth_mean_px = share[0] * depth_px[0] + share[1] * depth_px[1],
                        depth_difference_px = depth_px[0] - depth_px[1];
  observations[0].covariance =
      own[0] * sum_inverse * own[1] +
      grown(skin_from[0] * commonError(patch, 0, change) * skin_from[0].transpose(), change.key_from_now[0]) +
      depth_mean_px * depth_mean_px.transpose();
  observations[1].combine << skin_from[0], -skin_from[1];
  observations[1].jacobian = jacobian[0] - jacobian[1];
  observations[1].covariance = own[0] + own[1] + depth_difference_px * depth_difference_px.transpose();
  return observations;
}

}  // namespace facenav::head_tracking
