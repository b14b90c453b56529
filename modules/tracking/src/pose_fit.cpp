#include "pose_fit.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace facenav::tracking {
namespace {

constexpr double kNoise_grey = 1.3;
constexpr double kLeastFacing = 0.2;
constexpr double kBiweight = 4.685;      // 95 % efficiency for normal errors (Huber 1981)
constexpr double kLongestStep_px = 2.5;  // displacement beyond which a patch's linearisation means nothing
constexpr int kIterations[kLevels] = {6, 5, 5, 6};
constexpr double kSettled_px[kLevels] = {0.004, 0.03, 0.05,
                                         0.05};  // largest motion of a patch in the last step

struct CameraNow {
  const stereo::CameraModel& model;
  Eigen::Isometry3d camera_T_left;
  const cv::Mat1f& image;
};

struct Sums {
  float i = 0, ii = 0, ti = 0, ui = 0, vi = 0;
  bool is_inside = true;
};

// Warps the patch's samples to the current image (pinhole exactly, distortion linearised at the centre) and
// sums.
Sums sumPatch(const PatchLevel& level, const PatchLevel::Looks& looks, std::size_t first,
              const Eigen::Matrix3f& r, const Eigen::Vector3f& t, const Eigen::Matrix2f& d_px,
              const Eigen::Vector2f& px_offset, const cv::Mat1f& image) {
  Sums sums;
  const float right = float(image.cols - 2), bottom = float(image.rows - 2);
  for (std::size_t k = first; k < first + std::size_t(level.samples); ++k) {
    const float x = level.x[k], y = level.y[k], z = level.z[k];
    const float w = 1.f / (r(2, 0) * x + r(2, 1) * y + r(2, 2) * z + t(2));
    const float nx = (r(0, 0) * x + r(0, 1) * y + r(0, 2) * z + t(0)) * w;
    const float ny = (r(1, 0) * x + r(1, 1) * y + r(1, 2) * z + t(1)) * w;
    const float u = d_px(0, 0) * nx + d_px(0, 1) * ny + px_offset(0);
    const float v = d_px(1, 0) * nx + d_px(1, 1) * ny + px_offset(1);
    if (!(u >= 1 && v >= 1 && u < right && v < bottom)) {
      sums.is_inside = false;
      return sums;
    }
    const float grey = sampleAt(image, u, v);
    sums.i += grey;
    sums.ii += grey * grey;
    sums.ti += looks.grey[k] * grey;
    sums.ui += looks.d_u[k] * grey;
    sums.vi += looks.d_v[k] * grey;
  }
  return sums;
}

PatchSight sightOf(const PatchLevel& level, std::size_t index, int camera, const CameraNow& now,
                   const Eigen::Isometry3d& motion) {
  PatchSight sight;
  const Patch& patch = level.patches[index];
  const PatchView& view = patch.view[camera];
  if (!view.is_usable) return sight;
  const Eigen::Isometry3d camera_T_head = now.camera_T_left * motion;
  const Eigen::Vector3d centre_mm = camera_T_head * patch.centre_mm;
  if (centre_mm.z() < 1 ||
      -(camera_T_head.linear() * patch.normal).dot(centre_mm.normalized()) < kLeastFacing)
    return sight;
  Eigen::Matrix<double, 2, 3> d_p;
  sight.px = stereo::project(now.model, centre_mm, d_p);
  const double scale = 1.0 / (1 << level.level);
  const Eigen::Matrix2d d_px = scale * centre_mm.z() * d_p.leftCols<2>();
  const Eigen::Vector2d offset = scale * sight.px - d_px * centre_mm.hnormalized();
  const Sums sums = sumPatch(level, level.looks[camera], index * level.samples,
                             camera_T_head.linear().cast<float>(), camera_T_head.translation().cast<float>(),
                             d_px.cast<float>(), offset.cast<float>(), now.image);
  if (!sums.is_inside) return sight;
  const float n = float(level.samples), spread = sums.ii - sums.i * sums.i / n,
              gain = sums.ti / view.contrast;
  sight.is_visible = true;
  sight.ncc = spread > 1e-3f ? sums.ti / std::sqrt(spread * view.contrast) : 0.f;
  sight.expected_ncc = std::max(0.f, 1.f - n * float(kNoise_grey * kNoise_grey) / view.contrast);
  if (sight.ncc > 0.1f && gain > 0.05f)
    sight.displacement = -view.structure_inverse * Eigen::Vector2d(sums.ui, sums.vi) / double(gain);
  return sight;
}

PatchSights sightsOf(const stereo::StereoRig& rig, const PatchLevel& level,
                     const std::array<ImagePyramid, 2>& now, const Eigen::Isometry3d& motion) {
  const CameraNow cameras[2] = {{rig.left, Eigen::Isometry3d::Identity(), now[0].level[level.level]},
                                {rig.right, rig.right_T_left.isometry(), now[1].level[level.level]}};
  PatchSights sights(level.patches.size());
  for (std::size_t i = 0; i < sights.size(); ++i)
    for (int c = 0; c < 2; ++c) sights[i][c] = sightOf(level, i, c, cameras[c], motion);
  return sights;
}

// Trust before geometry: looks as expected, and a displacement within reach.
double looksWeight(const PatchSight& sight) {
  if (!sight.is_visible || sight.expected_ncc <= 0.05f) return 0.0;
  const double likeness = std::clamp((sight.ncc / sight.expected_ncc - 0.3) / 0.5, 0.0, 1.0);
  return sight.displacement.norm() < kLongestStep_px ? likeness : 0.1 * likeness;
}

struct Step {
  Vector6d xi = Vector6d::Zero();
  Matrix6d information = Matrix6d::Zero();
  double scale = 1.0;
};

double medianDistance(std::vector<double>& distances) {
  if (distances.empty()) return 0.0;
  std::nth_element(distances.begin(), distances.begin() + distances.size() / 2, distances.end());
  return distances[distances.size() / 2];
}

// The increment xi (Head, about the model's centre) that explains the displacements; fills weights and
// distances.
Step solve(const PatchLevel& level, const std::vector<double>& trust, PatchSights& sights) {
  Step step;
  for (int round = 0; round < 6; ++round) {
    std::vector<double> distances;
    for (std::size_t i = 0; i < sights.size(); ++i)
      for (int c = 0; c < 2; ++c) {
        auto& sight = sights[i][c];
        const auto& view = level.patches[i].view[c];
        sight.weight = looksWeight(sight);
        if (sight.weight <= 0) continue;
        const Eigen::Vector2d e = sight.displacement - view.jacobian * step.xi;
        sight.distance = std::sqrt(std::max(0.0, e.dot(view.information * e)));
        sight.residual_px = e.norm();
        distances.push_back(sight.distance);
      }
    step.scale = std::max(1.0, medianDistance(distances) / 1.177);  // of a 2-D normal error's length
    const double reach = kBiweight * step.scale;
    Matrix6d h = Matrix6d::Zero();
    Vector6d g = Vector6d::Zero();
    for (std::size_t i = 0; i < sights.size(); ++i)
      for (int c = 0; c < 2; ++c) {
        auto& sight = sights[i][c];
        if (sight.weight <= 0) continue;
        const auto& view = level.patches[i].view[c];
        const double q = sight.distance / reach;
        sight.weight *= round == 0 ? 1.0 / (1.0 + 4.0 * q * q) : (q < 1 ? std::pow(1 - q * q, 2) : 0.0);
        const double w = sight.weight * level.patches[i].rigidity * (trust.empty() ? 1.0 : trust[i]);
        const Eigen::Matrix<double, 6, 2> jl = w * view.jacobian.transpose() * view.information;
        h.noalias() += jl * view.jacobian;
        g.noalias() += jl * sight.displacement;
      }
    step.information = h;
    h.diagonal() += 1e-6 * h.diagonal() + Vector6d::Constant(1e-9);
    const Vector6d previous = step.xi;
    step.xi = h.ldlt().solve(g);
    if (!step.xi.allFinite()) {
      step.xi.setZero();
      break;
    }
    if (round > 1 && (step.xi - previous).tail<3>().norm() < 1e-4 &&
        (step.xi - previous).head<3>().norm() < 1e-6)
      break;
  }
  return step;
}

Eigen::Isometry3d about(const Eigen::Vector3d& centre_mm, const Vector6d& xi) {
  return Eigen::Translation3d(centre_mm) * expRigid(xi) * Eigen::Translation3d(-centre_mm);
}

// How far the step moves the patches, pixels of the level.
double motion_px(const PatchLevel& level, const Vector6d& xi) {
  double most = 0;
  for (const auto& patch : level.patches) most = std::max(most, (patch.view[0].jacobian * xi).norm());
  return most;
}

}  // namespace

PoseFit fitPose(const stereo::StereoRig& rig, const PatchModel& model, const std::array<ImagePyramid, 2>& now,
                const Eigen::Isometry3d& start, int first_level, const std::vector<double>& trust) {
  PoseFit fit;
  fit.motion = start;
  const std::vector<double> even;
  for (int l = first_level; l >= 0; --l) {
    const PatchLevel& level = model.level[l];
    if (level.patches.size() < 4) continue;
    for (int iteration = 0; iteration < kIterations[l]; ++iteration) {
      PatchSights sights = sightsOf(rig, level, now, fit.motion);
      const Step step = solve(level, l == 0 ? trust : even, sights);
      fit.motion = fit.motion * about(model.centre_mm, step.xi);
      if (l == 0) {
        fit.information = step.information;
        fit.scale = step.scale;
        fit.sights = std::move(sights);
      }
      if (motion_px(level, step.xi) < kSettled_px[l]) break;
    }
  }
  return fit;
}

}  // namespace facenav::tracking
