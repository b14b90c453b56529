#include "facenav/health/face_offset.h"

#include <algorithm>
#include <cmath>

#include "facenav/cameras/rig_uncertainty.h"
#include "facenav/core/robust_statistics.h"

namespace facenav::health {
namespace {

/// The match in the middle, by depth.
struct Middle {
  Correspondence match;
  double depth_mm = 0;
};

Middle middleOf(const cameras::StereoRig& rig, const std::vector<Correspondence>& matches) {
  std::vector<Middle> all;
  for (const auto& match : matches)
    all.push_back({match, cameras::triangulate(rig, match.left_px, match.right_px).mm.z()});
  const auto middle = all.begin() + std::ptrdiff_t(all.size() / 2);
  std::nth_element(all.begin(), middle, all.end(),
                   [](const Middle& a, const Middle& b) { return a.depth_mm < b.depth_mm; });
  return *middle;
}

}  // namespace

bool FaceOffset::isSignificant() const { return std::abs(median_px) > kSignificant * sigma_px; }

FaceOffset faceOffset(const cameras::StereoRig& rig, const std::vector<Correspondence>& matches) {
  std::vector<double> off_px;
  for (const auto& match : matches) {
    const double residual_px = cameras::epipolarResidual_px(rig, match.left_px, match.right_px);
    if (std::isfinite(residual_px)) off_px.push_back(residual_px);
  }
  FaceOffset offset;
  if (off_px.empty()) return offset;
  const Middle middle = middleOf(rig, matches);
  offset.median_px = upperMedian(off_px);
  offset.depth_mm = middle.depth_mm;
  const double spread_px = kSigmaPerMad * medianAbsoluteDeviation(off_px, offset.median_px);
  const auto uncertainty = cameras::uncertaintyOf(rig);
  double variance = std::pow(kMedianNoise * spread_px, 2) / double(off_px.size()) +
                    std::pow(kSharedShare * spread_px, 2) + std::pow(uncertainty.lens_px, 2);
  const double nominal_px = cameras::epipolarResidual_px(rig, middle.match.left_px, middle.match.right_px);
  for (const auto& other : uncertainty.one_sigma)
    variance += std::pow(
        cameras::epipolarResidual_px(other, middle.match.left_px, middle.match.right_px) - nominal_px, 2);
  offset.sigma_px = std::sqrt(variance);
  return offset;
}

double offsetOfDepthError_px(const cameras::StereoRig& rig, double error_mm, double depth_mm) {
  return error_mm * rig.baseline_mm() / depth_mm * rig.right.k(1, 1) / depth_mm;
}

}  // namespace facenav::health
