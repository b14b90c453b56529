#include "same_image.h"

#include <cmath>

#include "facenav/core/error.h"
#include "facenav/volume/nifti.h"

namespace facenav::steps {
namespace {

constexpr double kSameImage = 0.95;  // least correlation of an image with a copy that was rounded or scaled

}  // namespace

void requireSameImage(const casefile::CaseStore& store, const interop::T1& theirs, const interop::T1& ours) {
  const auto their_grid = interop::canonical(theirs.grid), our_grid = interop::canonical(ours.grid);
  if (their_grid.size != our_grid.size || their_grid.matches(our_grid)) return;  // check() says the first
  const auto a = volume::readNifti(theirs.path).volume, b = store.mri();
  constexpr double kSteps = 25;
  double n = 0, sum_a = 0, sum_b = 0, aa = 0, bb = 0, ab = 0;
  for (double i = 0; i < kSteps; ++i)
    for (double j = 0; j < kSteps; ++j)
      for (double k = 0; k < kSteps; ++k) {
        const Eigen::Vector3d part = Eigen::Vector3d(i, j, k) / (kSteps - 1);
        const Eigen::Vector3d ijk(std::round(part.x() * (our_grid.size[0] - 1)),
                                  std::round(part.y() * (our_grid.size[1] - 1)),
                                  std::round(part.z() * (our_grid.size[2] - 1)));
        const double x = volume::sampleLinear(a, a.grid.toVoxel(their_grid.toMri(ijk))),
                     y = volume::sampleLinear(b, b.grid.toVoxel(our_grid.toMri(ijk)));
        n += 1, sum_a += x, sum_b += y, aa += x * x, bb += y * y, ab += x * y;
      }
  const double variance = (aa - sum_a * sum_a / n) * (bb - sum_b * sum_b / n);
  if (variance > 0 && ab - sum_a * sum_b / n > kSameImage * std::sqrt(variance)) return;
  throw Error("is not the case's T1: its voxels hold another image", theirs.path.string(),
              "name the T1 that the case was prepared from");
}

}  // namespace facenav::steps
