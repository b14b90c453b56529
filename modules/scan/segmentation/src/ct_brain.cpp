#include "ct_brain.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "block_means.h"
#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "facenav/core/robust_statistics.h"
#include "facenav/volume/mask_morphology.h"
#include "facenav/volume/regrid.h"
#include "head_threshold.h"

namespace facenav::segmentation {
namespace {

using volume::Mask;
using volume::Volume;

// Physical values: air -1000, fat -100, fluid 0 to 15, brain 20 to 45, fresh blood 60 to 90, bone 200 and
// more.
constexpr float kLow_hu = -150, kHigh_hu = 250, kBone_hu = 180;
constexpr double kLeastBrain_hu = 5, kMostBrain_hu = 80;
constexpr double kSkullReach_mm = 14;  // reach outside the brain within which bone lies
constexpr double kLeastSkull = 0.5;    // share of the brain's surface with bone outside it; necks have none
constexpr double kStep_mm = 1, kSulcus_mm = 2, kSmooth_mm = 1.5;

[[noreturn]] void noBrain(const std::string& reason) {
  throw Error("no brain can be modelled: " + reason, {}, "a T1-weighted MR of the whole head is needed");
}

/// True if a ray outwards from a place of the surface meets bone.
bool meetsBone(const Volume& ct, const Eigen::Vector3d& from_mm, const Eigen::Vector3d& outwards) {
  for (double t = 0; t <= kSkullReach_mm; t += kStep_mm)
    if (volume::sampleLinear(ct, ct.grid.toVoxel(Point<Mri>(from_mm + t * outwards)), kLow_hu) > kBone_hu)
      return true;
  return false;
}

}  // namespace

bool isCt(const Volume& scan) {
  if (scan.modality == "CT") return true;
  if (scan.modality == "MR" || scan.voxels.empty()) return false;
  try {
    return findHeadThreshold(blockMeans(scan).mean, scan.modality).is_ct;
  } catch (const Error&) {  // the mask is empty
    return false;
  }
}

Volume softTissueWindow(const Volume& ct) {
  Volume shown = ct;
  for (float& value : shown.voxels)
    value = std::isfinite(value) ? std::clamp(value, kLow_hu, kHigh_hu) - kLow_hu : 0.f;
  return shown;
}

void requireSkullAround(const Volume& ct, const Mask& brain) {
  const Volume there = volume::resample(ct, brain.grid);
  std::vector<float> inside;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  const Mask surface = volume::surfaceVoxels(brain);
  std::vector<Eigen::Vector3d> places;
  std::size_t v = 0;
  for (int k = 0; k < brain.grid.size[2]; ++k)
    for (int j = 0; j < brain.grid.size[1]; ++j)
      for (int i = 0; i < brain.grid.size[0]; ++i, ++v) {
        if (!brain.voxels[v]) continue;
        inside.push_back(there.voxels[v]);
        const Eigen::Vector3d p = brain.grid.toMri({double(i), double(j), double(k)}).mm;
        centre += p;
        if (surface.voxels[v]) places.push_back(p);
      }
  if (inside.empty()) noBrain("nothing in this CT looks like one");
  centre /= double(inside.size());
  const float level = upperMedian(std::move(inside));
  if (level < kLeastBrain_hu || level > kMostBrain_hu)
    noBrain(
        formatted("what looks like a brain in this CT measures %.0f Hounsfield units (a brain has 20 to 45)",
                  double(level)));
  std::size_t with_bone = 0;
  for (const auto& p : places) with_bone += meetsBone(ct, p, (p - centre).normalized());
  const double share = double(with_bone) / double(places.size());
  if (share < kLeastSkull)
    noBrain(
        formatted("in this CT no skull lies around what looks like a brain (bone outside %.0f %% of it): a "
                  "phantom, or another part of the body",
                  100 * share));
}

Mask withinSkull(const Volume& ct, const Mask& brain) {
  const Volume there = volume::resample(ct, brain.grid);
  Mask soft = brain;
  for (std::size_t v = 0; v < soft.voxels.size(); ++v)
    soft.voxels[v] = brain.voxels[v] && there.voxels[v] < kBone_hu && there.voxels[v] > kLow_hu;
  return volume::largestPart(volume::open(volume::fillHoles(volume::close(soft, kSulcus_mm)), kSmooth_mm));
}

}  // namespace facenav::segmentation
