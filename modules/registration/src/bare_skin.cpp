#include "bare_skin.h"

#include <algorithm>
#include <iterator>

#include "skin_likelihood.h"
#include "skin_patches.h"

namespace facenav::registration {
namespace {

constexpr double kPatch_mm = 12.0;

long long cubeAt(const Eigen::Vector3d& p_mm) { return cubeOf(p_mm.cast<float>(), kPatch_mm); }

}  // namespace

Covers::Covers(const ScalpField& scalp, const PointCloud<Camera>& face, const std::vector<int>& points,
               const Eigen::Isometry3d& mri_T_camera) {
  const auto covered = SkinLikelihood(scalp, face, points, kPatch_mm)
                           .covered(FieldFitter(scalp, face, points).match(mri_T_camera));
  for (std::size_t p = 0; p < points.size(); ++p)
    if (covered[p] > 0.5f) cubes_.insert(cubeAt(face.points_mm[std::size_t(points[p])]));
}

bool Covers::hold(const Eigen::Vector3d& p_mm) const { return cubes_.count(cubeAt(p_mm)) > 0; }

std::vector<int> Covers::bare(const PointCloud<Camera>& face, const std::vector<int>& points) const {
  std::vector<int> out;
  std::copy_if(points.begin(), points.end(), std::back_inserter(out),
               [&](int p) { return !hold(face.points_mm[std::size_t(p)]); });
  return out;
}

}  // namespace facenav::registration
