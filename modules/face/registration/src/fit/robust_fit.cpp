#include "robust_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "cloud/cloud_sampling.h"
#include "cloud/cube_numbers.h"
#include "cloud/skin_patches.h"
#include "facenav/core/robust_statistics.h"

namespace facenav::registration {
namespace {

constexpr float kOutside = 0.67f;  // tighter limit outside the skin, where occlusions lie
// Number of points looked at, and fitted. More do not improve the fit, since neighbours share their error.
constexpr std::size_t kLooked = 7000, kMostPoints = 6000;
constexpr std::size_t kMostEven = 10000;
constexpr double kHairPatch_mm = 10.0;
// Divisor of log likelihoods, since the likelihood assumes more independence between patches than there is.
constexpr double kTemper = 2.0;
constexpr double kLeastWeight = 0.02;  // a pose less probable than this is outside a 95 % bound
constexpr double kSame_rad = 0.005, kSame_mm = 0.5;

}  // namespace

std::vector<float> patchWeights(const std::vector<PointMatch>& matches, double reach_mm, double noise_mm) {
  CubeNumbers numbers(kHairPatch_mm);
  std::vector<int> patch_of(matches.size(), -1);
  std::vector<std::vector<float>> residuals;
  for (std::size_t p = 0; p < matches.size(); ++p) {
    const PointMatch& m = matches[p];
    if (!m.is_valid) continue;
    patch_of[p] = numbers.of(m.at_mri_mm);
    if (std::size_t(patch_of[p]) == residuals.size()) residuals.emplace_back();
    if (std::abs(m.residual_mm) < float(reach_mm))
      residuals[std::size_t(patch_of[p])].push_back(m.residual_mm);
  }
  constexpr float kNone = std::numeric_limits<float>::infinity();
  std::vector<float> middle(residuals.size(), kNone);
  std::vector<double> sizes;
  for (std::size_t i = 0; i < residuals.size(); ++i) {
    if (residuals[i].size() < 4) continue;
    middle[i] = selectRank(residuals[i], residuals[i].size() / 2);
    sizes.push_back(double(std::abs(middle[i])));
  }
  const double most = std::max(1.5, double(kNoiseReach) * noise_mm);
  const double limit = std::clamp(kSigmaPerMad * 4.0 * upperMedian(sizes), 0.5, most);
  std::vector<float> weights(matches.size(), 0.0f);
  for (std::size_t p = 0; p < matches.size(); ++p)
    if (patch_of[p] >= 0) weights[p] = tukeyWeight(middle[std::size_t(patch_of[p])], float(limit));
  return weights;
}

double inlierLimit_mm(const std::vector<PointMatch>& matches, double reach_mm, double noise_mm) {
  std::vector<double> sizes;
  for (const PointMatch& m : matches)
    if (m.is_valid && std::abs(m.residual_mm) < float(reach_mm))
      sizes.push_back(double(std::abs(m.residual_mm)));
  return std::clamp(4.0 * kSigmaPerMad * upperMedian(sizes), 0.6,
                    std::max(3.0, double(kNoiseReach) * noise_mm));
}

namespace {

float widestLimit_mm(double noise_mm) { return std::max(2.0f, kNoiseReach * float(noise_mm)); }

/// Fits again with new weights, from within 1 to 2 mm.
void closeIn(FieldFitter& fitter, Eigen::Isometry3d& mri_T_camera, float& limit_mm, double noise_mm) {
  const auto matches = fitter.match(mri_T_camera);
  fitter.setWeights(patchWeights(matches, std::max(4.0, double(kNoiseReach) * noise_mm), noise_mm));
  limit_mm = std::min(std::max(1.5f, kNoiseReach * float(noise_mm)),
                      float(inlierLimit_mm(matches, double(limit_mm), noise_mm)));
  mri_T_camera = fitter.fit(mri_T_camera, {limit_mm, kOutside * limit_mm, 3, true});
}

/// Spread of the poses in `others` that stay distinct after a fit of all points, weighted by their
/// likelihood.
Matrix6d doubtOf(const std::vector<PartFit>& others, const Eigen::Isometry3d& mri_T_camera,
                 FieldFitter& fitter, const Eigen::Vector3d& middle, double noise_mm) {
  std::vector<Eigen::Isometry3d> seen{mri_T_camera};
  Matrix6d sum = Matrix6d::Zero();
  double total = 1;
  for (std::size_t o = 1; o < others.size(); ++o) {
    Eigen::Isometry3d pose = others[o].mri_T_camera;
    const double weight = std::exp((others[o].log_likelihood - others.front().log_likelihood) / kTemper);
    const auto is_new = [&] {
      return std::all_of(seen.begin(), seen.end(), [&](const Eigen::Isometry3d& s) {
        return areDistinct(s, pose, middle, kSame_rad, kSame_mm);
      });
    };
    if (weight < kLeastWeight || !is_new()) continue;
    float limit_mm = widestLimit_mm(noise_mm);
    closeIn(fitter, pose, limit_mm, noise_mm);
    if (!is_new()) continue;
    seen.push_back(pose);
    const Eigen::Isometry3d apart = pose * mri_T_camera.inverse();
    Vector6d d;
    d << logRotation(apart.linear()), apart * middle - middle;
    sum += weight * d * d.transpose();
    total += weight;
  }
  return sum / total;
}

}  // namespace

RobustFit fitFace(const ScalpField& scalp, const PointCloud<Camera>& face,
                  const Eigen::Isometry3d& mri_T_camera, double noise_mm) {
  RobustFit fit;
  fit.mri_T_camera = mri_T_camera;
  fit.points =
      someOf(nearHead(scalp, face, someOf(finitePoints(face), kLooked), mri_T_camera, 20.0), kMostPoints);
  const auto some = thinOut(face, fit.points, 3.0, 4000), few = thinOut(face, some, 6.0, 800);
  const auto parts = fitParts(scalp, face, few, mri_T_camera, noise_mm);
  fit.mri_T_camera = parts.front().mri_T_camera;
  fit.covers = Covers(scalp, face, some, fit.mri_T_camera, noise_mm);
  fit.points = fit.covers.bare(face, fit.points);
  FieldFitter sparse(scalp, face, fit.covers.bare(face, some)), all(scalp, face, fit.points);
  float limit_mm = widestLimit_mm(noise_mm);
  closeIn(sparse, fit.mri_T_camera, limit_mm, noise_mm);
  fit.doubt = doubtOf(parts, fit.mri_T_camera, sparse, scalp.middle_mm(), noise_mm);
  closeIn(all, fit.mri_T_camera, limit_mm, noise_mm);
  fit.limit_mm = double(limit_mm);
  return fit;
}

std::vector<int> evenPoints(const ScalpField& scalp, const PointCloud<Camera>& face, const RobustFit& fit) {
  const auto near = nearHead(scalp, face, finitePoints(face), fit.mri_T_camera, 20.0);
  return fit.covers.bare(face, thinOut(face, near, 1.0, kMostEven));
}

std::optional<RobustFit> fitFromGuess(const ScalpField& scalp, const PointCloud<Camera>& face,
                                      const AlignmentStart& start) {
  const auto straight = descend(scalp, face, start);
  if (!straight) return {};
  return fitFace(scalp, face, straight->mri_T_camera, start.noise_mm);
}

}  // namespace facenav::registration
