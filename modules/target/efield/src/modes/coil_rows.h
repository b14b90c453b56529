#pragma once
// What dipoles outside the head give: the flux weights of the equations, and the coil's own field at points.
// Lengths in mm, moments in A m^2. "Field units": m x (p - q) / |p - q|^3, which kFieldOfUnits turns into
// V/m.

#include "facenav/efield/coil_dipoles.h"
#include "facenav/geometry/rigid_transform.h"
#include "model/boundary_system.h"

namespace facenav::efield {

/// -mu0 / (4 pi) times 1 A/us, and 1e6 for distances in mm: field units to V/m.
constexpr double kFieldOfUnits = -1e5;

struct DipoleArray {
  Eigen::Matrix3Xf positions_mm, moments;  // Mri
  Eigen::Index size() const { return positions_mm.cols(); }
};
/// Sources of `dipoles_each` dipoles, one source after the other.
struct SourceArray {
  DipoleArray dipoles;
  int dipoles_each = 1;
  Eigen::Index size() const { return dipoles.size() / dipoles_each; }
  SourceArray part(Eigen::Index first, Eigen::Index count) const {
    const Eigen::Index from = first * dipoles_each, some = count * dipoles_each;
    return {{dipoles.positions_mm.middleCols(from, some), dipoles.moments.middleCols(from, some)},
            dipoles_each};
  }
};
DipoleArray dipolesAt(const CoilDipoles& coil, const RigidTransform<Mri, frames::Coil>& mri_T_coil);

/// Flux weights of all dipoles together: one column, a value per vertex of the system.
Eigen::MatrixXf fluxOf(const BoundarySystem& system, const DipoleArray& dipoles);
/// Flux weights, one column per source.
Eigen::MatrixXf fluxOfEach(const BoundarySystem& system, const SourceArray& sources);
/// Field of each source alone, in field units: one column per source, rows x of all points (padded), y, z.
Eigen::MatrixXf primaryOfEach(const PointArrays& points, const SourceArray& sources);
/// Pull of the system's vertices: one column per row of primaryOfEach, in the same order; times weights / 4
/// pi gives the secondary field in field units.
Eigen::MatrixXf pullsAt(const BoundarySystem& system, const PointArrays& points);
/// pullsAt() for one block of points after the other, in the same memory.
class PullBlocks {
 public:
  explicit PullBlocks(const BoundarySystem& system) : system_(system) {}
  /// Counts until the next call.
  const Eigen::MatrixXf& at(const PointArrays& points);

 private:
  const BoundarySystem& system_;
  Eigen::MatrixXf pulls_;
};

}  // namespace facenav::efield
