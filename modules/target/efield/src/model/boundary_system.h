#pragma once
// BoundarySystem: the equations of the boundary element method for a head model, factorised. Unknown: the
// electric potential at the vertices of all surfaces, linear on each triangle (de Munck 1992, IEEE Trans
// Biomed Eng 39:986), for a current source in the innermost compartment (Geselowitz 1967). The coil's field
// follows by reciprocity: what the potentials of a source add to the magnetic flux through the coil.
// Lengths in mm, conductivities in S/m.

#include <Eigen/Core>
#include <vector>

#include "dense/lu.h"
#include "facenav/core/task_monitor.h"
#include "facenav/efield/shell_mesh.h"
#include "kernels/field_kernel.h"

namespace facenav::efield {

/// Points in three padded arrays, as the kernels need them. Padding lies far away.
struct PointArrays {
  Eigen::VectorXf x, y, z;
  Eigen::Index count = 0;  // without padding

  explicit PointArrays(const Eigen::Matrix3Xd& points_mm = Eigen::Matrix3Xd(3, 0));
  kernels::Points points() const { return {x.data(), y.data(), z.data(), x.size()}; }
};

/// A closed surface and the conductivities on both sides.
struct Shell {
  ShellMesh mesh;
  double inside = 0, outside = 0;
};
/// Shells of a model, the innermost first. Throws Error unless each is closed.
std::vector<Shell> shellsOf(const HeadModel& head, const Conductivities& conductivities);

/// The innermost shell's charges spread over its triangles, for points near to it: seen from nearer than
/// about an edge, charges at the vertices alone are lumps.
struct SpreadCharges {
  static constexpr int kNodes = 9;  // of a triangle: middles of its parts
  float shares[kNodes][3];          // of a node by corner
  Eigen::Matrix3Xf nodes;           // kNodes places a triangle
  PointArrays centres;              // of the triangles
  Eigen::Matrix3Xi corners;
  Eigen::Matrix3Xf areas;  // part of each corner's area that one node stands for
  float reach_mm = 0;      // a triangle is near to a point if its centre lies within it

  explicit SpreadCharges(const ShellMesh& mesh);
};

struct BoundarySystem {
  std::vector<Eigen::Index> first;  // number of each shell's first vertex, and of all
  Eigen::Matrix3Xd vertices_mm;
  PointArrays vertices, flux_places;  // flux_places: where the coil's field is taken, one a vertex
  Eigen::Matrix3Xf flux_weights;      // area vector times the step of conductivity
  Eigen::MatrixXf lu;
  dense::Pivots pivots;
  SpreadCharges spread;  // of the first shell

  BoundarySystem(const std::vector<Shell>& shells, TaskMonitor& monitor);
  Eigen::Index size() const { return vertices_mm.cols(); }
  /// Takes each shell's mean from each column: an equal potential on a closed surface adds no flux.
  void removeMeans(Eigen::Ref<Eigen::MatrixXf> columns) const;
};

/// Matrix of the equations before its factorisation; its rows sum to 0, and `deflation` is added to all.
Eigen::MatrixXf boundaryMatrix(const std::vector<Shell>& shells, double deflation, TaskMonitor& monitor);

/// Solid angle of a triangle seen from the origin, shared out among its corners by their linear functions.
/// Positive if it is seen from behind (its normal points away from the origin). 0 in the triangle's plane.
Eigen::Vector3d linearSolidAngles(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                  const Eigen::Vector3d& c);

}  // namespace facenav::efield
