#pragma once
// RadialShell: a closed surface given by its distance from a middle in the directions of an icosphere.

#include <functional>

#include "facenav/efield/shell_mesh.h"

namespace facenav::efield {

struct RadialShell {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  ShellMesh directions;  // unit sphere
  Eigen::VectorXd radius_mm;

  ShellMesh mesh() const;
  Eigen::Vector3d vertex(Eigen::Index i) const {
    return middle + radius_mm[i] * directions.vertices_mm.col(i);
  }
  /// Cosine of the angle between each direction and the surface's normal, at least 0.3.
  Eigen::VectorXd cosines() const;
};

/// Gives the same surface by its distances in other directions, each linear between the old ones.
RadialShell inDirections(const RadialShell& shell, const ShellMesh& directions);
/// Mean of each value with its neighbours' on the mesh, `steps` times. It leaves a ball a ball.
Eigen::VectorXd smoothedOn(const ShellMesh& mesh, Eigen::VectorXd values, int steps);
/// Distance of each vertex of `outer` to the surface `inner`; negative inside it.
Eigen::VectorXd gaps_mm(const ShellMesh& inner, const ShellMesh& outer);

/// Where a ray from `middle` last (or, with `is_first`, first) falls below 0.5 within `reach_mm`; 0 if it
/// never reaches 0.5, and reach_mm if it never falls. `value`: at a point, mm.
double edgeAlong(const std::function<double(const Eigen::Vector3d&)>& value, const Eigen::Vector3d& middle,
                 const Eigen::Vector3d& direction, double reach_mm, bool is_first);

}  // namespace facenav::efield
