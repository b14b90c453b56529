#include "facenav/registration/skin_fit.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "cloud/skin_patches.h"
#include "facenav/anatomy/face_regions.h"
#include "facenav/core/number_text.h"
#include "facenav/core/robust_statistics.h"

namespace facenav::registration {
namespace {

constexpr double kFar_mm = 15.0;  // farther points are background or clothes
constexpr int kLeastPoints = 50;
constexpr double kCovered_mm = 2.0;  // hair lies off the skin by this and more, skin hardly ever

}  // namespace

std::vector<RegionFit> fitByRegion(const ScalpField& scalp, const PointCloud<Camera>& face,
                                   const AlignmentResult& alignment) {
  const anatomy::FaceRegions regions(scalp.noseTip_mm());
  const Eigen::Isometry3d mri_T_camera = alignment.camera_T_mri.isometry().inverse();
  std::map<std::string, std::pair<std::vector<double>, int>> found;  // residuals; number not in the fit
  for (std::size_t p = 0; p < face.size() && p < alignment.residual_mm.size(); ++p) {
    if (!(std::abs(alignment.residual_mm[p]) < kFar_mm)) continue;
    auto& [residuals_mm, foreign] = found[regions.nameOf(mri_T_camera * face.points_mm[p])];
    residuals_mm.push_back(alignment.residual_mm[p]);
    foreign += !alignment.is_inlier[p];
  }
  std::vector<RegionFit> fits;
  for (const auto& [region, points] : found) {
    const int all = int(points.first.size());
    if (all >= kLeastPoints)
      fits.push_back({region, upperMedian(points.first), double(points.second) / double(all), all});
  }
  std::sort(fits.begin(), fits.end(), [](const RegionFit& a, const RegionFit& b) {
    return std::abs(a.offset_mm) > std::abs(b.offset_mm);
  });
  return fits;
}

std::string inWords(const RegionFit& fit) {
  if (fit.offset_mm > kCovered_mm) return fit.region + " covered (hair or an object)";
  return fit.region + formatted(" %.1f mm %s the MRI's skin", std::abs(fit.offset_mm),
                                fit.offset_mm > 0 ? "outside" : "inside");
}

}  // namespace facenav::registration
