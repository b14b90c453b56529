#include "facenav/health/face_offset.h"

#include <algorithm>
#include <cmath>

#include "facenav/cameras/rig_uncertainty.h"
#include "facenav/core/robust_statistics.h"

namespace facenav::health {
namespace {

struct Seen {
  Correspondence match;
  double off_px = 0, depth_mm = 0;
};

/// The matches that lie in front of the cameras.
std::vector<Seen> inFront(const cameras::StereoRig& rig, const std::vector<Correspondence>& matches) {
  std::vector<Seen> seen;
  for (const auto& match : matches) {
    const double off_px = cameras::epipolarResidual_px(rig, match.left_px, match.right_px);
    if (std::isfinite(off_px))
      seen.push_back({match, off_px, cameras::triangulate(rig, match.left_px, match.right_px).mm.z()});
  }
  return seen;
}

}  // namespace

bool FaceOffset::isSignificant() const { return std::abs(median_px) > kSignificant * sigma_px; }

FaceOffset faceOffset(const cameras::StereoRig& rig, const std::vector<Correspondence>& matches) {
  auto seen = inFront(rig, matches);
  if (seen.empty()) return {};
  const auto middle = seen.begin() + std::ptrdiff_t(seen.size() / 2);
  std::nth_element(seen.begin(), middle, seen.end(),
                   [](const Seen& a, const Seen& b) { return a.depth_mm < b.depth_mm; });
  std::vector<double> off_px;
  for (const auto& one : seen) off_px.push_back(one.off_px);
  FaceOffset offset;
  offset.median_px = upperMedian(off_px);
  offset.depth_mm = middle->depth_mm;
  const double spread_px = kSigmaPerMad * medianAbsoluteDeviation(off_px, offset.median_px);
  const auto uncertainty = cameras::uncertaintyOf(rig);
  double variance = std::pow(kMedianNoise * spread_px, 2) / double(off_px.size()) +
                    std::pow(kSharedShare * spread_px, 2) + std::pow(uncertainty.lens_px, 2);
  const Correspondence& there = middle->match;
  for (const auto& other : uncertainty.one_sigma)
    variance +=
        std::pow(cameras::epipolarResidual_px(other, there.left_px, there.right_px) - middle->off_px, 2);
  offset.sigma_px = std::sqrt(variance);
  return offset;
}

double offsetOfDepthError_px(const cameras::StereoRig& rig, double error_mm, double depth_mm) {
  return error_mm * rig.baseline_mm() / depth_mm * rig.right.k(1, 1) / depth_mm;
}

}  // namespace facenav::health
