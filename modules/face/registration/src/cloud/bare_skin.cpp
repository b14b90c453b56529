#include "bare_skin.h"

#include <algorithm>
#include <iterator>

#include "fit/skin_likelihood.h"

namespace facenav::registration {
Covers::Covers(const ScalpField& scalp, const PointCloud<Camera>& face, const std::vector<int>& points,
               const Eigen::Isometry3d& mri_T_camera, double noise_mm) {
  const auto covered = SkinLikelihood(scalp, face, points, noise_mm, kPatch_mm)
                           .covered(FieldFitter(scalp, face, points).match(mri_T_camera));
  for (std::size_t p = 0; p < points.size(); ++p)
    if (covered[p] > 0.5f) cubes_.of(face.points_mm[std::size_t(points[p])].cast<float>());
}

bool Covers::hold(const Eigen::Vector3d& p_mm) const { return cubes_.find(p_mm.cast<float>()) >= 0; }

std::vector<int> Covers::bare(const PointCloud<Camera>& face, const std::vector<int>& points) const {
  std::vector<int> out;
  std::copy_if(points.begin(), points.end(), std::back_inserter(out),
               [&](int p) { return !hold(face.points_mm[std::size_t(p)]); });
  return out;
}

}  // namespace facenav::registration
