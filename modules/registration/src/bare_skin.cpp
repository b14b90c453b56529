#include "bare_skin.h"

#include <algorithm>
#include <iterator>

#include "cloud_sampling.h"
#include "skin_likelihood.h"
#include "skin_patches.h"

namespace facenav::registration {
namespace {

constexpr double kPatch_mm = 12.0, kSpacing_mm = 3.0;
constexpr std::size_t kMostPoints = 4000;

long long cubeAt(const Eigen::Vector3d& p_mm) { return cubeOf(p_mm.cast<float>(), kPatch_mm); }

}  // namespace

Covers::Covers(const ScalpField& scalp, const PointCloud<Camera>& face, const std::vector<int>& points,
               const Eigen::Isometry3d& mri_T_camera) {
  const std::vector<int> some = thinOut(face, points, kSpacing_mm, kMostPoints);
  const auto covered = SkinLikelihood(scalp, face, some, kPatch_mm)
                           .covered(FieldFitter(scalp, face, some).match(mri_T_camera));
  for (std::size_t p = 0; p < some.size(); ++p)
    if (covered[p] > 0.5f) cubes_.insert(cubeAt(face.points_mm[std::size_t(some[p])]));
}

bool Covers::hold(const Eigen::Vector3d& p_mm) const { return cubes_.count(cubeAt(p_mm)) > 0; }

std::vector<int> Covers::bare(const PointCloud<Camera>& face, const std::vector<int>& points) const {
  std::vector<int> out;
  std::copy_if(points.begin(), points.end(), std::back_inserter(out),
               [&](int p) { return !hold(face.points_mm[std::size_t(p)]); });
  return out;
}

}  // namespace facenav::registration
