#pragma once
// CoilSource: a coil as its file describes it, before it becomes dipoles: magnetic dipoles, pieces of wire,
// or a vector potential sampled on a grid. Frame Coil. Read by readCoilSource (coil_file.h); dipolesOf turns
// it into the one form that the fields need. The direction of the current is that of the file.

#include <Eigen/Geometry>
#include <array>
#include <string>
#include <vector>

#include "facenav/efield/coil_dipoles.h"

namespace facenav::efield {

/// Pieces of wire: middle and length vector along the current.
struct LineElements {
  Eigen::Matrix3Xd positions_mm, lengths_mm;  ///< 3 x n, for a current of 1 A
};

/// Vector potential on a grid, x fastest.
struct PotentialGrid {
  std::array<int, 3> size{0, 0, 0};
  Eigen::Affine3d coil_from_voxel = Eigen::Affine3d::Identity();  ///< mm
  Eigen::Matrix3Xd potential_Tm;                                  ///< T m per ampere, axes of Coil
  std::string file = {};                                          ///< where it was read, for messages
  Eigen::Index index(int i, int j, int k) const {
    return i + Eigen::Index(size[0]) * (j + Eigen::Index(size[1]) * k);
  }
};

struct CoilSource {
  CoilDipoles dipoles;  ///< those in the file; name and largest rate of the whole coil
  LineElements lines;
  std::vector<PotentialGrid> grids;
  std::vector<std::string> notes = {};  ///< what a user should know about the file, in plain words
};

/// Vector potential of dipoles and of pieces of wire, T m per ampere, at points of the frame Coil.
Eigen::Matrix3Xd potentialOf(const CoilDipoles& dipoles, const Eigen::Matrix3Xd& points_mm);
Eigen::Matrix3Xd potentialOf(const LineElements& lines, const Eigen::Matrix3Xd& points_mm);

/// Flux density along z of dipoles and of pieces of wire, T per ampere, at points of the frame Coil.
Eigen::VectorXd fluxOf(const CoilDipoles& dipoles, const Eigen::Matrix3Xd& points_mm);
Eigen::VectorXd fluxOf(const LineElements& lines, const Eigen::Matrix3Xd& points_mm);

/// Magnetic dipoles of a closed winding: each piece spans a triangle with a point above the winding's middle,
/// filled with dipoles at most `spacing_mm` apart.
CoilDipoles dipolesOf(const LineElements& lines, double spacing_mm = 3);
/// Dipoles near the contact face whose field below the coil is that of the grid, by least squares. Throws
/// Error where the grid does not reach below the contact face.
CoilDipoles dipolesOf(const PotentialGrid& grid);
/// All of a coil as dipoles, not thinned. Throws Error as above.
CoilDipoles dipolesOf(const CoilSource& source);

}  // namespace facenav::efield
