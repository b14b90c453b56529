#include "facenav/plan/field_region.h"

#include <algorithm>
#include <cmath>

#include "facenav/atlas/brain_template.h"
#include "facenav/core/error.h"

namespace facenav::steps {
namespace {

constexpr double kReach_mm = 80, kStep_mm = 2;
constexpr std::size_t kAtOnce = 5000;  // places between two looks whether it is cancelled
constexpr std::array<double, 3> kShares{0.5, 0.75, 0.9};

using Eigen::Vector3d;
using Eigen::Vector3i;

/// Every n-th voxel of the brain mask near the coil.
struct CoarseMask {
  volume::VoxelGrid grid;
  std::vector<char> is_brain;
};

CoarseMask coarseMask(const volume::Mask& mask, const Vector3d& middle_mm) {
  Vector3i step, first, count;
  const Vector3d spacing_mm = mask.grid.spacing_mm(), middle = mask.grid.toVoxel(Point<Mri>(middle_mm));
  CoarseMask coarse;
  for (int c = 0; c < 3; ++c) {
    step[c] = std::max(1, int(std::lround(kStep_mm / spacing_mm[c])));
    const int last = mask.grid.size[std::size_t(c)] - 1;
    const double reach = kReach_mm / spacing_mm[c];
    const int low = std::clamp(int(std::floor((middle[c] - reach) / step[c])), 0, last / step[c]);
    const int high = std::clamp(int(std::ceil((middle[c] + reach) / step[c])), low, last / step[c]);
    first[c] = low * step[c];
    count[c] = coarse.grid.size[std::size_t(c)] = high - low + 1;
  }
  coarse.grid.mri_from_voxel = mask.grid.mri_from_voxel;
  coarse.grid.mri_from_voxel.translation() = mask.grid.mri_from_voxel * first.cast<double>();
  coarse.grid.mri_from_voxel.linear() = mask.grid.mri_from_voxel.linear() * step.cast<double>().asDiagonal();
  for (int k = 0; k < count[2]; ++k)
    for (int j = 0; j < count[1]; ++j)
      for (int i = 0; i < count[0]; ++i)
        coarse.is_brain.push_back(
            mask.at(first[0] + i * step[0], first[1] + j * step[1], first[2] + k * step[2]));
  return coarse;
}

/// True for a voxel of the brain, or next to one: slices interpolate between voxels.
bool isAtBrain(const CoarseMask& mask, int i, int j, int k) {
  for (int z = k - 1; z <= k + 1; ++z)
    for (int y = j - 1; y <= j + 1; ++y)
      for (int x = i - 1; x <= i + 1; ++x)
        if (mask.grid.contains(x, y, z) && mask.is_brain[mask.grid.index(x, y, z)]) return true;
  return false;
}

std::shared_ptr<const volume::Volume> strengthIn(const CoarseMask& mask, const HeadField& head,
                                                 const efield::CoilDipoles& coil, const CoilPose& pose,
                                                 TaskMonitor& monitor) {
  std::vector<Vector3d> places;
  std::vector<std::size_t> voxels;
  for (int k = 0; k < mask.grid.size[2]; ++k)
    for (int j = 0; j < mask.grid.size[1]; ++j)
      for (int i = 0; i < mask.grid.size[0]; ++i) {
        const Vector3d p = mask.grid.toMri(Vector3d(i, j, k)).mm;
        if ((p - pose.translation_mm()).norm() > kReach_mm || !isAtBrain(mask, i, j, k)) continue;
        places.push_back(p);
        voxels.push_back(mask.grid.index(i, j, k));
      }
  auto strength = std::make_shared<volume::Volume>();
  strength->grid = mask.grid;
  strength->voxels.assign(mask.grid.count(), 0.f);
  for (std::size_t first = 0; first < places.size(); first += kAtOnce) {
    monitor.report("field in the brain", double(first) / double(places.size()));
    const std::size_t count = std::min(kAtOnce, places.size() - first);
    const Eigen::Map<const Eigen::Matrix3Xd> at_mm(places[first].data(), 3, Eigen::Index(count));
    const Eigen::Matrix3Xd field = head.at(coil, pose, at_mm);
    for (std::size_t v = 0; v < count; ++v)
      strength->voxels[voxels[first + v]] = float(field.col(Eigen::Index(v)).norm());
  }
  return strength;
}

void addVolumes(FieldRegions& regions, const CoarseMask& mask, const volume::Volume& strength, double peak,
                const LabelOf& label) {
  const double each_ml = mask.grid.voxelVolume_mm3() / 1000;
  for (int k = 0; k < mask.grid.size[2]; ++k)
    for (int j = 0; j < mask.grid.size[1]; ++j)
      for (int i = 0; i < mask.grid.size[0]; ++i) {
        const std::size_t voxel = mask.grid.index(i, j, k);
        const double value = strength.voxels[voxel];
        if (!mask.is_brain[voxel] || value < kShares[0] * peak) continue;
        const std::string name = label ? label(mask.grid.toMri(Vector3d(i, j, k))) : "";
        for (auto& region : regions) {
          if (value < region.share * peak) continue;
          region.volume_ml += each_ml;
          if (!name.empty()) region.by_label[name] += each_ml;
        }
      }
}

/// Part of a triangle where a linear function with these corners, largest first, is at least `least`.
double shareAbove(std::array<double, 3> corners, double least) {
  std::sort(corners.begin(), corners.end(), std::greater<>());
  const auto [a, b, c] = corners;
  if (c >= least) return 1;
  if (a < least) return 0;
  if (b < least) return (a - least) / (a - b) * ((a - least) / (a - c));
  return 1 - (least - c) / (a - c) * ((least - c) / (b - c));
}

}  // namespace

LabelOf aalLabels(const casefile::CaseStore& store) {
  const auto map = store.atlas();
  if (!map) return {};
  try {
    const auto labels = std::make_shared<const atlas::LabelMap>(atlas::readColin27().aal);
    return [labels, map](const Point<Mri>& p) { return atlas::labelAt(*labels, map->toMni(p)).name; };
  } catch (const Error&) {
    return {};  // the regions are then without labels
  }
}

double areaAbove_mm2(const surface::TriangleMesh& mesh, const Eigen::VectorXd& values, double least) {
  double area_mm2 = 0;
  for (const auto& t : mesh.triangles) {
    const double share = shareAbove({values[t[0]], values[t[1]], values[t[2]]}, least);
    if (share <= 0) continue;
    const Vector3d& a = mesh.vertices_mm[std::size_t(t[0])];
    const Vector3d ab = mesh.vertices_mm[std::size_t(t[1])] - a, ac = mesh.vertices_mm[std::size_t(t[2])] - a;
    area_mm2 += 0.5 * share * ab.cross(ac).norm();
  }
  return area_mm2;
}

FieldInBrain fieldInBrain(const HeadField& head, const FieldSurfaces& surfaces,
                          const efield::CoilDipoles& coil, const guidance::Target& target,
                          const FieldOnCortex& on_cortex, TaskMonitor& monitor, const LabelOf& label) {
  if (!surfaces.brain_mask)
    throw Error("the case has no brain mask, so the field in the brain is not known", {},
                "write the field on the cortex (.vtp, .msh)");
  const CoilPose pose = coilPoseOf(target);
  const CoarseMask mask = coarseMask(*surfaces.brain_mask, pose.translation_mm());
  FieldInBrain result;
  const Eigen::VectorXd on_surface = on_cortex.field.colwise().norm().transpose();
  for (std::size_t r = 0; r < result.regions.size(); ++r) {
    result.regions[r].share = kShares[r];
    result.regions[r].area_mm2 = areaAbove_mm2(surfaces.cortex, on_surface, kShares[r] * on_cortex.peak);
  }
  result.strength = strengthIn(mask, head, coil, pose, monitor);
  addVolumes(result.regions, mask, *result.strength, on_cortex.peak, label);
  return result;
}

PoseComparison comparePoses(const HeadField& head, const HeadField& other_head, const FieldSurfaces& surfaces,
                            const efield::CoilDipoles& coil, const guidance::Target& target,
                            const guidance::Target& other) {
  const auto here = fieldOnCortex(head, surfaces, coil, target);
  const auto there = fieldOnCortex(other_head, surfaces, coil, other);
  PoseComparison result;
  result.at_target = here.at_target.norm();
  const Eigen::Matrix3Xd place = target.cortex_point.mm;
  result.other_at_target = other_head.at(coil, coilPoseOf(other), place).norm();
  result.other_at_its_own = there.at_target.norm();
  result.peak_ratio = there.peak / here.peak;
  result.peak_shift_mm = (there.peak_place.mm - here.peak_place.mm).norm();
  Eigen::VectorXd a = here.field.colwise().norm().transpose(), b = there.field.colwise().norm().transpose();
  a.array() -= a.mean();
  b.array() -= b.mean();
  result.correlation = a.dot(b) / (a.norm() * b.norm());
  return result;
}

}  // namespace facenav::steps
