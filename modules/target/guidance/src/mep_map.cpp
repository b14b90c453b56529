#include "facenav/guidance/mep_map.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace facenav::guidance {
namespace {

struct MapValue {
  double mep_uv = 0, nearest_mm = 0;  // mean of the MEPs; distance of the nearest site
};

MapValue mapAt(const Eigen::Vector3d& p_mm, const std::vector<MepSite>& sites, double sigma_mm) {
  double weights = 0, sum_uv = 0, nearest2_mm2 = std::numeric_limits<double>::infinity();
  const double per_mm2 = 0.5 / (sigma_mm * sigma_mm);
  for (const MepSite& site : sites) {
    const double d2_mm2 = (site.point.mm - p_mm).squaredNorm();
    nearest2_mm2 = std::min(nearest2_mm2, d2_mm2);
    const double weight = std::exp(-per_mm2 * d2_mm2);
    weights += weight;
    sum_uv += weight * site.mep_uv;
  }
  return {weights > 0 ? sum_uv / weights : 0.0, std::sqrt(nearest2_mm2)};
}

/// Area at or above the threshold: each vertex that reaches it contributes a third of its triangles.
double areaAbove_mm2(const surface::TriangleMesh& surface, const std::vector<float>& mep_uv,
                     double threshold_uv) {
  double area_mm2 = 0;
  for (const Eigen::Vector3i& triangle : surface.triangles) {
    int above = 0;
    for (const int vertex : triangle) above += mep_uv[std::size_t(vertex)] >= threshold_uv;  // NaN: false
    if (above == 0) continue;
    const auto& a = surface.vertices_mm[std::size_t(triangle[0])];
    const Eigen::Vector3d ab = surface.vertices_mm[std::size_t(triangle[1])] - a;
    const Eigen::Vector3d ac = surface.vertices_mm[std::size_t(triangle[2])] - a;
    area_mm2 += 0.5 * ab.cross(ac).norm() * above / 3.0;
  }
  return area_mm2;
}

void describeSites(const std::vector<MepSite>& sites, double threshold_uv, MepMap& map) {
  Eigen::Vector3d weighted = Eigen::Vector3d::Zero();
  double sum_uv = 0;
  for (const MepSite& site : sites) {
    weighted += site.mep_uv * site.point.mm;
    sum_uv += site.mep_uv;
    map.largest_uv = std::max(map.largest_uv, site.mep_uv);
    map.responses += site.mep_uv >= threshold_uv;
  }
  map.sites = int(sites.size());
  map.centre_of_gravity = Point<Mri>(weighted / sum_uv);
}

/// Distance along the ray, or nothing (Moeller and Trumbore 1997).
std::optional<double> hit_mm(const Eigen::Vector3d& from, const Eigen::Vector3d& along,
                             const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  const Eigen::Vector3d ab = b - a, ac = c - a, p = along.cross(ac);
  const double determinant = ab.dot(p);
  if (std::abs(determinant) < 1e-12) return std::nullopt;
  const Eigen::Vector3d s = from - a, q = s.cross(ab);
  const double u = s.dot(p) / determinant, v = along.dot(q) / determinant;
  const double t_mm = ac.dot(q) / determinant;
  if (u < 0 || v < 0 || u + v > 1 || t_mm < 0) return std::nullopt;
  return t_mm;
}

}  // namespace

std::optional<MepMap> mepMap(const surface::TriangleMesh& surface, const std::vector<MepSite>& sites,
                             const MepMapOptions& options) {
  const bool has_response =
      std::any_of(sites.begin(), sites.end(), [](const MepSite& site) { return site.mep_uv > 0; });
  if (!has_response) return std::nullopt;
  MepMap map;
  describeSites(sites, options.mep_threshold_uv, map);
  map.mep_uv.reserve(surface.vertices_mm.size());
  bool has_peak = false;
  for (const Eigen::Vector3d& p_mm : surface.vertices_mm) {
    const MapValue value = mapAt(p_mm, sites, options.mep_sigma_mm);
    const bool is_near = value.nearest_mm <= options.mep_reach_mm;
    map.mep_uv.push_back(is_near ? float(value.mep_uv) : std::numeric_limits<float>::quiet_NaN());
    if (!is_near || value.nearest_mm > options.mep_sigma_mm || (has_peak && value.mep_uv <= map.peak_uv))
      continue;
    map.peak = Point<Mri>(p_mm);
    map.peak_uv = value.mep_uv;
    has_peak = true;
  }
  if (!has_peak) return std::nullopt;
  map.area_mm2 = areaAbove_mm2(surface, map.mep_uv, options.mep_threshold_uv);
  return map;
}

std::optional<Point<Mri>> axisOnSurface(const surface::TriangleMesh& surface,
                                        const RigidTransform<Mri, Coil>& mri_T_coil) {
  const Eigen::Vector3d from = mri_T_coil.translation_mm(), along = mri_T_coil.rotation().col(2);
  std::optional<double> nearest_mm;
  for (const Eigen::Vector3i& triangle : surface.triangles) {
    const auto t_mm =
        hit_mm(from, along, surface.vertices_mm[std::size_t(triangle[0])],
               surface.vertices_mm[std::size_t(triangle[1])], surface.vertices_mm[std::size_t(triangle[2])]);
    if (t_mm && (!nearest_mm || *t_mm < *nearest_mm)) nearest_mm = t_mm;
  }
  if (!nearest_mm) return std::nullopt;
  return Point<Mri>(from + *nearest_mm * along);
}

}  // namespace facenav::guidance
