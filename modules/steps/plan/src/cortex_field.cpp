#include "facenav/plan/cortex_field.h"

#include <cmath>
#include <limits>

#include "facenav/core/error.h"
#include "facenav/geometry/rotation.h"

namespace facenav::steps {
namespace {

constexpr double kPatch_mm = 3;

const volume::Mask& maskOf(const FieldSurfaces& surfaces) {
  if (surfaces.brain_mask) return *surfaces.brain_mask;
  throw Error("the case has no brain mask, so the field in the brain is not known", {},
              "write the field on the cortex (.vtp, .msh)");
}

Eigen::Map<const Eigen::Matrix3Xd> asMatrix(const std::vector<Eigen::Vector3d>& points) {
  return {points.empty() ? nullptr : points[0].data(), 3, Eigen::Index(points.size())};
}

}  // namespace

CortexNormal cortexNormal(const FieldSurfaces& surfaces, const guidance::Target& target) {
  const auto& mesh = surfaces.cortex;
  std::size_t nearest = 0;
  double least = 1e300;
  for (std::size_t i = 0; i < mesh.vertices_mm.size(); ++i)
    if (const double d = (mesh.vertices_mm[i] - target.cortex_point.mm).squaredNorm(); d < least)
      least = d, nearest = i;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < mesh.vertices_mm.size(); ++i) {
    const bool is_near = (mesh.vertices_mm[i] - mesh.vertices_mm[nearest]).norm() <= kPatch_mm;
    // The other bank of the sulcus faces this one and does not count.
    if (is_near && mesh.normals[i].dot(mesh.normals[nearest]) > 0) sum += mesh.normals[i];
  }
  CortexNormal result;
  result.normal = sum.normalized();
  const Eigen::Vector3d out = -target.mri_T_target.rotation().col(2);
  result.off_radial_deg = std::acos(std::clamp(result.normal.dot(out), -1.0, 1.0)) * kDegPerRad;
  return result;
}

FieldOnCortex fieldOnCortex(const HeadField& head, const FieldSurfaces& surfaces,
                            const efield::CoilDipoles& coil, const guidance::Target& target) {
  const CoilPose pose = coilPoseOf(target);
  FieldOnCortex result;
  result.field = head.at(coil, pose, asMatrix(surfaces.cortex.vertices_mm));
  result.at_target = head.at(coil, pose, Eigen::Matrix3Xd(target.cortex_point.mm)).col(0);
  result.normal = cortexNormal(surfaces, target);
  result.along_normal = head.hasDirections() ? result.at_target.dot(result.normal.normal)
                                             : std::numeric_limits<double>::quiet_NaN();
  Eigen::Index strongest = 0;
  result.peak = std::sqrt(result.field.colwise().squaredNorm().maxCoeff(&strongest));
  result.peak_place = Point<Mri>(surfaces.cortex.vertices_mm[std::size_t(strongest)]);
  result.peak_distance_mm = (result.peak_place.mm - target.cortex_point.mm).norm();
  return result;
}

volume::Volume fieldVolume(const HeadField& head, const FieldSurfaces& surfaces,
                           const efield::CoilDipoles& coil, const CoilPose& mri_T_coil,
                           double rate_A_per_us) {
  const auto& mask = maskOf(surfaces);
  std::vector<Eigen::Vector3d> places;
  std::vector<std::size_t> voxels;
  for (int k = 0; k < mask.grid.size[2]; ++k)
    for (int j = 0; j < mask.grid.size[1]; ++j)
      for (int i = 0; i < mask.grid.size[0]; ++i) {
        if (!mask.at(i, j, k)) continue;
        places.push_back(mask.grid.toMri({double(i), double(j), double(k)}).mm);
        voxels.push_back(mask.grid.index(i, j, k));
      }
  const Eigen::Matrix3Xd field = head.at(coil, mri_T_coil, asMatrix(places));
  volume::Volume result;
  result.grid = mask.grid;
  result.voxels.assign(mask.grid.count(), 0.f);
  for (std::size_t v = 0; v < voxels.size(); ++v)
    result.voxels[voxels[v]] = float(rate_A_per_us * field.col(Eigen::Index(v)).norm());
  return result;
}

double doseByField_pct(double hotspot_at_unit_rate, double target_at_unit_rate, double threshold_pct) {
  if (!(target_at_unit_rate > 0)) throw Error("the coil gives no field at the target", {}, "check its pose");
  return threshold_pct * hotspot_at_unit_rate / target_at_unit_rate;
}

}  // namespace facenav::steps
