#include "facenav/efield/brain_surface.h"

#include <algorithm>

#include "facenav/core/error.h"
#include "facenav/surface/closest_point.h"
#include "facenav/volume/mask_morphology.h"
#include "facenav/volume/regrid.h"
#include "facenav/volume/smoothing.h"
#include "model/cell_surface.h"
#include "model/shell_surface.h"
#include "model/solid_mask.h"

namespace facenav::efield {
namespace {

using Eigen::Index;
using Eigen::Vector3d;

constexpr double kSpacing_mm = 1.0;     // of the grid on which the surface is found
constexpr double kAimedFluid_mm = 2.0;  // the brain is cut where it comes nearer to the inner skull
constexpr double kPlainPart = 1.0 / 3;  // of the brain's height, from below, that gets no sulci
constexpr double kClosing_mm = 8.0;     // there
constexpr double kDeepest_mm = 28.0;  // below the inner skull no sulcus is followed: the field is small there
constexpr double kSeam_mm = 3.0;
constexpr double kBlur_mm = 2.0;  // of the edge between brain and fluid
constexpr int kSmoothing = 3;     // passes; 1.2 mm
constexpr double kCoarser = 1.04;
constexpr int kPushSteps = 6;

const char* const kPrepareAgain = "correct the brain mask, or prepare the case again";

/// The voxels that are to be brain although they lie outside the cortex: holes, deep places, and what closing
/// adds in the lower part. With a margin in the brain, so that no seam is left.
volume::Mask filledPlaces(const volume::Mask& brain, const volume::Mask& skull) {
  const auto& size = brain.grid.size;
  const std::size_t slice = std::size_t(size[0]) * std::size_t(size[1]);
  const auto first = std::find(brain.voxels.begin(), brain.voxels.end(), 1) - brain.voxels.begin();
  const auto last = std::find(brain.voxels.rbegin(), brain.voxels.rend(), 1).base() - brain.voxels.begin();
  const double lowest = double(std::size_t(first) / slice), highest = double(std::size_t(last) / slice);
  volume::Mask filled = volume::close(brain, kClosing_mm);
  const std::size_t plain = slice * std::size_t(lowest + kPlainPart * (highest - lowest));
  std::copy(brain.voxels.begin() + long(plain), brain.voxels.end(), filled.voxels.begin() + long(plain));
  filled = volume::fillHoles(volume::unionOf(filled, volume::erode(skull, kDeepest_mm)));
  volume::Mask added = filled;
  for (std::size_t v = 0; v < added.voxels.size(); ++v)
    added.voxels[v] = filled.voxels[v] && !brain.voxels[v];
  return volume::intersection(filled, volume::dilate(added, kSeam_mm));
}

/// Share of brain at each place, smooth, with room for the fluid below the inner skull.
volume::Volume brainShare(const surface::TriangleMesh& cortex, const ShellMesh& inner_skull) {
  const surface::TriangleMesh skull_mesh = triangleMesh(inner_skull);
  const volume::VoxelGrid grid = gridAround(skull_mesh, kSpacing_mm, 12.0);
  const volume::Mask brain = solidMask(cortex, grid), skull = solidMask(skull_mesh, grid);
  if (brain.volume_ml() <= 0) throw Error("the case's cortex lies outside the brain mask", {}, kPrepareAgain);
  volume::Volume share = solidShare(cortex, brain, 0, kBlur_mm);
  const volume::Mask filled = filledPlaces(brain, skull);
  for (std::size_t v = 0; v < share.voxels.size(); ++v)
    share.voxels[v] = std::max(share.voxels[v], float(filled.voxels[v]));
  for (int pass = 0; pass < kSmoothing; ++pass) share = volume::smoothed(std::move(share));
  const volume::Volume room = solidShare(skull_mesh, skull, kAimedFluid_mm, kBlur_mm);
  for (std::size_t v = 0; v < share.voxels.size(); ++v)
    share.voxels[v] = std::min(share.voxels[v], room.voxels[v]);
  return share;
}

/// The brain on a grid of `cell_mm`, as one part without holes.
volume::Mask coarseBrain(const volume::Volume& share, double cell_mm) {
  volume::VoxelGrid grid = share.grid;
  const double spacing_mm = grid.spacing_mm()[0];
  grid.mri_from_voxel.linear() *= cell_mm / spacing_mm;
  for (int& size : grid.size) size = int(size * spacing_mm / cell_mm) + 1;
  volume::Mask coarse = volume::resampledAbove(share, 0.5f, grid);
  coarse = volume::fillHoles(volume::largestPart(coarse));
  joinDiagonals(coarse, share);
  coarse = volume::fillHoles(coarse);
  joinDiagonals(coarse, share);
  return coarse;
}

/// Moves vertices inwards that come nearer to the inner skull than the least thickness of the fluid.
void keepFluid(ShellMesh& brain, const ShellMesh& inner_skull) {
  const surface::ClosestPoint skull(triangleMesh(inner_skull));
  for (int step = 0; step < kPushSteps; ++step) {
    bool has_room = true;
    for (Index i = 0; i < brain.vertices_mm.cols(); ++i) {
      const auto place = skull.nearest(Point<Mri>(brain.vertices_mm.col(i)));
      const double depth_mm = place.is_outside ? -place.distance_mm : place.distance_mm;
      if (depth_mm >= kLeastFluid_mm) continue;
      has_room = false;
      brain.vertices_mm.col(i) -= (1.05 * kLeastFluid_mm - depth_mm) * place.normal.v;
    }
    if (has_room) return;
  }
  throw Error("the brain comes nearer than 1 mm to the skull", {}, kPrepareAgain);
}

}  // namespace

ShellMesh brainSurface(const surface::TriangleMesh& cortex, const ShellMesh& inner_skull,
                       const BrainSurfaceOptions& options) {
  const volume::Volume share = brainShare(cortex, inner_skull);
  constexpr double kCoarsest_mm = 40;
  for (double cell_mm = options.finest_mm; cell_mm < kCoarsest_mm; cell_mm *= kCoarser) {
    ShellMesh brain = cellSurface(coarseBrain(share, cell_mm), share);
    if (brain.vertices_mm.cols() == 0 || brain.vertices_mm.cols() > options.most_vertices) continue;
    keepFluid(brain, inner_skull);
    requireClosed(brain, "brain");
    return brain;
  }
  throw Error("the case's cortex gives no closed surface", {}, kPrepareAgain);
}

}  // namespace facenav::efield
