#include "robust_fit.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "cloud_sampling.h"
#include "skin_patches.h"

namespace facenav::registration {
namespace {

constexpr float kOutside = 0.67f;           // foreign things lie outside the skin: let go there first
constexpr std::size_t kMostPoints = 10000;  // more add nothing: neighbours share their error
constexpr double kHairPatch_mm = 10.0;

}  // namespace

std::vector<float> patchWeights(const std::vector<PointMatch>& matches, double reach_mm) {
  std::unordered_map<long long, std::vector<double>> patches;
  for (const PointMatch& m : matches)
    if (m.is_valid && std::abs(m.residual_mm) < float(reach_mm))
      patches[cubeOf(m.at_mri_mm, kHairPatch_mm)].push_back(double(m.residual_mm));
  std::unordered_map<long long, double> middle;
  std::vector<double> sizes;
  for (const auto& [key, residuals] : patches) {
    if (residuals.size() < 4) continue;
    middle[key] = median(residuals);
    sizes.push_back(std::abs(middle[key]));
  }
  const double limit = std::clamp(1.4826 * 4.0 * median(sizes), 0.5, 1.5);
  std::vector<float> weights(matches.size(), 0.0f);
  for (std::size_t p = 0; p < matches.size(); ++p) {
    if (!matches[p].is_valid) continue;
    const auto patch = middle.find(cubeOf(matches[p].at_mri_mm, kHairPatch_mm));
    if (patch != middle.end()) weights[p] = tukeyWeight(float(patch->second), float(limit));
  }
  return weights;
}

double inlierLimit_mm(const std::vector<PointMatch>& matches, double reach_mm) {
  std::vector<double> sizes;
  for (const PointMatch& m : matches)
    if (m.is_valid && std::abs(m.residual_mm) < float(reach_mm))
      sizes.push_back(double(std::abs(m.residual_mm)));
  return std::clamp(4.0 * 1.4826 * median(sizes), 0.6, 3.0);
}

RobustFit fitFace(const ScalpField& scalp, const PointCloud<Camera>& face,
                  const Eigen::Isometry3d& mri_T_camera) {
  RobustFit fit{mri_T_camera};
  fit.points = thinOut(face, nearHead(scalp, face, mri_T_camera, 20.0), 1.0, kMostPoints);
  const PartFit parts = bestOfParts(scalp, face, thinOut(face, fit.points, 6.0, 1000), mri_T_camera);
  fit.mri_T_camera = parts.mri_T_camera;
  fit.doubt = parts.doubt;
  FieldFitter sparse(scalp, face, thinOut(face, fit.points, 3.0, 4000)), all(scalp, face, fit.points);
  float limit_mm = 2.0f;
  for (FieldFitter* fitter : {&sparse, &all}) {
    const auto matches = fitter->match(fit.mri_T_camera);
    fitter->setWeights(patchWeights(matches, 4.0));
    limit_mm = std::min(1.5f, float(inlierLimit_mm(matches, double(limit_mm))));
    fit.mri_T_camera = fitter->fit(fit.mri_T_camera, {limit_mm, kOutside * limit_mm, 3, true});
  }
  fit.limit_mm = double(limit_mm);
  return fit;
}

std::optional<RobustFit> fitFromGuess(const ScalpField& scalp, const PointCloud<Camera>& face,
                                      const AlignmentStart& start) {
  const auto straight = descend(scalp, face, start);
  if (!straight) return {};
  return fitFace(scalp, face, straight->mri_T_camera);
}

}  // namespace facenav::registration
