#include "facenav/efield/head_model.h"

#include <algorithm>
#include <cmath>

#include "facenav/core/error.h"
#include "facenav/surface/closest_point.h"
#include "facenav/volume/mask_morphology.h"
#include "facenav/volume/regrid.h"
#include "model/radial_shell.h"
#include "model/shell_surface.h"

namespace facenav::efield {
namespace {

using Eigen::Index;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double kUpperScale = 0.75;  // grading: edges on top against the mean
constexpr double kSpacing_mm = 2.0;   // of the grid on which the brain mask is closed
constexpr double kClosing_mm = 10.0;  // bridges the fissures and the cleft above the cerebellum
// Fluid between grey matter and bone: masks of another method that hold the fluid lie 2.6 and 3.3 mm (median,
// upper half) off the brain masks of two heads (brainbrowser's structural1, t1_dicom).
constexpr double kFluidRim_mm = 3.0;
constexpr double kSkull_mm = 6.0;         // thickness; 6 mm everywhere costs 0.85 % of the field
constexpr double kSkullShare = 0.4;       // at most this part of the way from inner skull to skin
constexpr double kSkinReach_mm = 4.0;     // the skin's mesh corrects the mask's edge by at most this
constexpr double kMostAdded = 0.35;       // of the mask's volume by closing; more are holes, not fissures
constexpr double kLeastOnePart = 0.9;     // of the mask's volume
constexpr double kMostCut = 0.03;         // of the directions beside the brain (an ear, a tip)
constexpr double kBesideBrain_mm = 20.0;  // above the brain's lowest place the head must be whole
constexpr double kMostTouching = 0.02;    // of the directions in which brain mask and skin may touch
constexpr double kLongest_mm = 400.0;
constexpr int kSmoothing = 2, kGapSteps = 8;

const char* const kPrepareAgain = "correct the brain mask, or prepare the case again";

/// The brain without clefts, on a coarse grid.
volume::Mask closedBrain(const volume::Mask& brain) {
  if (brain.volume_ml() <= 0) throw Error("the case has no brain mask", {}, kPrepareAgain);
  const volume::VoxelGrid grid = volume::gridAround(brain, kSpacing_mm, kClosing_mm + 10);
  const volume::Mask coarse = volume::resample(brain, grid), part = volume::largestPart(coarse);
  if (part.volume_ml() < kLeastOnePart * coarse.volume_ml())
    throw Error("the brain mask consists of several parts", {}, kPrepareAgain);
  const volume::Mask closed = volume::fillHoles(volume::close(part, kClosing_mm));
  if (closed.volume_ml() > (1 + kMostAdded) * part.volume_ml())
    throw Error("the brain mask has large holes or gaps", {}, kPrepareAgain);
  return closed;
}

/// Throws Error if the scan's border cuts the brain; the brainstem may be cut.
void requireWholeBrain(const volume::Mask& brain) {
  const auto& n = brain.grid.size;
  double lowest_z = 1e9;
  std::size_t set = 0;
  std::vector<double> border_z;
  for (int k = 0; k < n[2]; ++k)
    for (int j = 0; j < n[1]; ++j)
      for (int i = 0; i < n[0]; ++i) {
        if (!brain.at(i, j, k)) continue;
        const double z = brain.grid.toMri(Vector3d(i, j, k)).mm.z();
        lowest_z = std::min(lowest_z, z), ++set;
        if (i == 0 || j == 0 || k == 0 || i == n[0] - 1 || j == n[1] - 1 || k == n[2] - 1)
          border_z.push_back(z);
      }
  const auto cut = std::count_if(border_z.begin(), border_z.end(),
                                 [&](double z) { return z > lowest_z + kBesideBrain_mm; });
  if (double(cut) > 1e-4 * double(set))
    throw Error("the scan's border cuts the brain", {}, "take a scan of the whole head");
}

Vector3d middleOf(const volume::Mask& mask) {
  Vector3d sum = Vector3d::Zero();
  double count = 0;
  for (int k = 0; k < mask.grid.size[2]; ++k)
    for (int j = 0; j < mask.grid.size[1]; ++j)
      for (int i = 0; i < mask.grid.size[0]; ++i)
        if (mask.at(i, j, k)) sum += Vector3d(i, j, k), count += 1;
  return mask.grid.toMri(sum / count).mm;
}

RadialShell innerSkull(const volume::Mask& brain, int divisions) {
  const volume::Mask closed = closedBrain(brain);
  RadialShell shell;
  shell.middle = middleOf(closed);
  shell.directions = icosphere(divisions, kUpperScale);
  volume::Volume distance;
  distance.grid = closed.grid;
  distance.voxels = volume::distanceTo(closed);
  // A voxel's centre lies half a voxel below the mask's surface.
  const double level_mm = kFluidRim_mm + kSpacing_mm / 2;
  const auto value = [&](const Vector3d& p) {
    return 0.5 + level_mm - volume::sampleLinear(distance, distance.grid.toVoxel(Point<Mri>(p)), 1e3f);
  };
  const Index count = shell.directions.vertices_mm.cols();
  shell.radius_mm.resize(count);
  for (Index i = 0; i < count; ++i)
    shell.radius_mm[i] =
        edgeAlong(value, shell.middle, shell.directions.vertices_mm.col(i), kLongest_mm, false);
  shell.radius_mm = smoothedOn(shell.directions, shell.radius_mm, kSmoothing);
  return shell;
}

/// Distance along a ray at which it leaves the grid.
double borderAlong(const volume::VoxelGrid& grid, const Vector3d& middle, const Vector3d& direction) {
  const Vector3d from = grid.toVoxel(Point<Mri>(middle));
  const Vector3d step = grid.mri_from_voxel.linear().inverse() * direction;
  double leaves_mm = kLongest_mm;
  for (int axis = 0; axis < 3; ++axis) {
    const double end = step[axis] > 0 ? grid.size[std::size_t(axis)] - 1.0 : 0.0;
    if (std::abs(step[axis]) > 1e-9) leaves_mm = std::min(leaves_mm, (end - from[axis]) / step[axis]);
  }
  return std::max(0.0, leaves_mm);
}

RadialShell scalpAround(const RadialShell& inner, const volume::Mask& head,
                        const surface::TriangleMesh& skin) {
  RadialShell shell = inner;
  const double beside_z = inner.mesh().vertices_mm.row(2).minCoeff() + kBesideBrain_mm;
  std::optional<surface::ClosestPoint> nearest;
  if (!skin.triangles.empty()) nearest.emplace(skin);
  const auto value = [&](const Vector3d& p) {
    return double(volume::sampleLinear(head, head.grid.toVoxel(Point<Mri>(p))));
  };
  int cut = 0;
  for (Index i = 0; i < shell.radius_mm.size(); ++i) {
    const Vector3d direction = shell.directions.vertices_mm.col(i);
    const double border_mm = borderAlong(head.grid, shell.middle, direction);
    const double edge_mm = edgeAlong(value, shell.middle, direction, border_mm, true);
    shell.radius_mm[i] = edge_mm;
    if (edge_mm >= border_mm - head.grid.spacing_mm().maxCoeff()) {
      cut += shell.vertex(i).z() > beside_z;
    } else if (nearest) {
      const auto place = nearest->nearest(Point<Mri>(shell.vertex(i)));
      if (place.distance_mm < kSkinReach_mm)
        shell.radius_mm[i] += place.is_outside ? -place.distance_mm : place.distance_mm;
    }
  }
  if (cut > kMostCut * double(shell.radius_mm.size()))
    throw Error("the scan's border cuts the head beside the brain", {}, "take a scan of the whole head");
  shell.radius_mm = smoothedOn(shell.directions, shell.radius_mm, kSmoothing);
  return shell;
}

/// Throws Error if the skin lies within or on the brain in many places; moves it out where it does in few.
void requireRoom(const RadialShell& inner, RadialShell& scalp) {
  const VectorXd least = 2.2 * kLeastGap_mm * inner.cosines().cwiseInverse();
  const auto touching = ((scalp.radius_mm - inner.radius_mm).array() < least.array()).count();
  if (double(touching) > kMostTouching * double(least.size()))
    throw Error("the brain mask reaches the skin", {}, kPrepareAgain);
  scalp.radius_mm = scalp.radius_mm.cwiseMax(inner.radius_mm + least);
}

/// How much nearer than the least gap the surfaces come at each vertex of `outer`, mm. A vertex of `inner`
/// counts at the corners of the triangle next to it.
VectorXd lackOfRoom_mm(const ShellMesh& inner, const ShellMesh& outer) {
  VectorXd lack_mm = (1.05 * kLeastGap_mm - gaps_mm(inner, outer).array()).max(0.0);
  const surface::ClosestPoint surface(triangleMesh(outer));
  for (const auto vertex : inner.vertices_mm.colwise()) {
    const auto place = surface.nearest(Point<Mri>(vertex));
    const double gap_mm = place.is_outside ? -place.distance_mm : place.distance_mm;
    for (const int corner : outer.triangles.col(place.triangle))
      lack_mm[corner] = std::max(lack_mm[corner], 1.05 * kLeastGap_mm - gap_mm);
  }
  return lack_mm;
}

/// Moves vertices of `outer` outwards until its gap to `inner` is the least one everywhere.
void openGap(const RadialShell& inner, RadialShell& outer) {
  const ShellMesh inner_mesh = inner.mesh();
  for (int step = 0; step < kGapSteps; ++step) {
    const VectorXd lack = lackOfRoom_mm(inner_mesh, outer.mesh());
    if (lack.maxCoeff() <= 0.05 * kLeastGap_mm) return;
    outer.radius_mm += lack.cwiseQuotient(outer.cosines());
  }
  throw Error("the surfaces of skull and skin come nearer than 2 mm to each other", {}, kPrepareAgain);
}

}  // namespace

HeadModel buildHeadModel(const volume::Mask& brain, const volume::Mask& head,
                         const surface::TriangleMesh& skin, int divisions) {
  requireWholeBrain(brain);
  const RadialShell inner = innerSkull(brain, divisions);
  RadialShell scalp = scalpAround(inner, head, skin);
  requireRoom(inner, scalp);
  RadialShell outer = inner;
  const VectorXd room = scalp.radius_mm - inner.radius_mm;
  outer.radius_mm +=
      smoothedOn(inner.directions, (kSkull_mm * inner.cosines().cwiseInverse()).cwiseMin(kSkullShare * room),
                 kSmoothing);
  // The field is smooth there: fewer vertices cost 0.01 % in balls, and halve the equations' memory.
  const ShellMesh coarser = geodesicSphere(outerParts(divisions), kUpperScale);
  outer = inDirections(outer, coarser);
  scalp = inDirections(scalp, coarser);
  openGap(inner, outer);
  openGap(outer, scalp);
  return {scalp.mesh(), outer.mesh(), inner.mesh()};
}

}  // namespace facenav::efield
