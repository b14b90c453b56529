#include "fit_report.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "facenav/core/error.h"
#include "pose_covariance.h"

namespace facenav::registration {
namespace {

constexpr double kHairPatch_mm = 10.0;

AlignmentResult describe(const SkinField& skin, const PointCloud<Camera>& face, const FinalFit& fit) {
  AlignmentResult result;
  result.camera_T_mri = RigidTransform<Camera, Mri>::fromIsometry(fit.mri_T_camera.inverse());
  const PoseFitter fitter(skin, face);
  const auto matches = fitter.match(fit.mri_T_camera, true);
  std::vector<double> weights = patchWeights(matches, 4.0);
  double squares = 0;
  std::size_t offered = 0;
  for (std::size_t p = 0; p < matches.size(); ++p) {
    const double residual = matches[p].residual_mm;
    const bool is_inlier = weights[p] > 0 && std::abs(residual) < fit.limit_mm;
    offered += matches[p].is_valid && std::abs(residual) < 15;
    weights[p] *= tukeyWeight(residual, fit.limit_mm);
    result.is_inlier.push_back(is_inlier);
    result.residual_mm.push_back(residual);
    if (!is_inlier) continue;
    ++result.points;
    squares += residual * residual;
    result.max_mm = std::max(result.max_mm, std::abs(residual));
  }
  result.rms_mm = result.points ? std::sqrt(squares / result.points) : 0.0;
  result.inlier_fraction = offered ? double(result.points) / double(offered) : 0.0;
  result.covariance = poseCovariance(matches, weights, fit.mri_T_camera, {});
  return result;
}

}  // namespace

double median(std::vector<double> values) {
  if (values.empty()) return 0.0;
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

/// Weights 0..1 of points by how well the patch of skin around them fits as a whole: hair, a collar or
/// swollen skin lifts whole patches, noise does not.
std::vector<double> patchWeights(const std::vector<PointMatch>& matches, double reach_mm) {
  std::unordered_map<long long, std::vector<double>> patches;
  for (const PointMatch& m : matches)
    if (m.is_valid && std::abs(m.residual_mm) < reach_mm)
      patches[patchKey(m.at_mri_mm, kHairPatch_mm)].push_back(m.residual_mm);
  std::unordered_map<long long, double> middle;
  std::vector<double> sizes;
  for (const auto& [key, residuals] : patches) {
    if (residuals.size() < 4) continue;
    middle[key] = median(residuals);
    sizes.push_back(std::abs(middle[key]));
  }
  const double limit = std::clamp(1.4826 * 4.0 * median(sizes), 0.5, 1.5);
  std::vector<double> weights(matches.size(), 0.0);
  for (std::size_t p = 0; p < matches.size(); ++p) {
    const auto patch = middle.find(patchKey(matches[p].at_mri_mm, kHairPatch_mm));
    if (matches[p].is_valid && patch != middle.end()) weights[p] = tukeyWeight(patch->second, limit);
  }
  return weights;
}

double inlierLimit_mm(const std::vector<PointMatch>& matches, double reach_mm) {
  std::vector<double> sizes;
  for (const PointMatch& m : matches)
    if (m.is_valid && std::abs(m.residual_mm) < reach_mm) sizes.push_back(std::abs(m.residual_mm));
  return std::clamp(4.0 * 1.4826 * median(sizes), 0.6, 3.0);
}

AlignmentResult report(const SkinField& skin, const PointCloud<Camera>& face, const FinalFit& fit,
                       const std::vector<Candidate>& rivals) {
  AlignmentResult result = describe(skin, face, fit);
  FitEvidence evidence = gatherEvidence(skin, face, fit.mri_T_camera, rivals);
  evidence.predicted_error_mm = result.predictedError_mm(Point<Mri>(0.5 * (skin.low() + skin.high())));
  requireTrust(evidence);
  return result;
}

void requireMaterial(const SkinModel& skin, const PointCloud<Camera>& face) {
  if (!skin.has_face)
    throw Error("not aligned: the MRI shows no face to align to", {},
                "use a scan with the face in it (not defaced)");
  std::size_t finite = 0;
  for (const auto& p : face.points_mm) finite += p.allFinite();
  if (finite < 500)
    throw Error("not aligned: too little of the face was measured (" + std::to_string(finite) + " points)",
                {}, "show the whole face to both cameras, with the dots on it");
}

}  // namespace facenav::registration
