#pragma once
// FieldSolver: the electric field that a coil induces in a head, by the boundary element method. The
// equations of a head are factorised once; fieldAt() is direct and slow (0.4 s for 5,000 points), CortexField
// (cortex_field.h) is fast. The method is in model/boundary_system.h. Fields are in V/m for a rate of the
// current of 1 A/us, Mri.

#include <memory>
#include <vector>

#include "facenav/core/task_monitor.h"
#include "facenav/efield/coil_dipoles.h"
#include "facenav/efield/shell_mesh.h"
#include "facenav/geometry/rigid_transform.h"

namespace facenav::efield {

struct BoundarySystem;

class FieldSolver {
 public:
  /// Builds and factorises the equations: 4 bytes times the square of the number of vertices. Throws Error
  /// for a surface that is not closed, Cancelled.
  FieldSolver(HeadModel head, const Conductivities& conductivities, TaskMonitor& monitor);
  ~FieldSolver();
  FieldSolver(FieldSolver&&) noexcept;
  FieldSolver& operator=(FieldSolver&&) noexcept;

  /// Field at points inside the innermost surface, 3 x n.
  Eigen::Matrix3Xd fieldAt(const CoilDipoles& coil, const RigidTransform<Mri, frames::Coil>& mri_T_coil,
                           const Eigen::Matrix3Xd& points_mm) const;

  const HeadModel& head() const { return head_; }
  /// Surface of the compartment in which fields are computed.
  const ShellMesh& innermost() const { return head_.brain ? *head_.brain : head_.inner_skull; }
  const BoundarySystem& system() const { return *system_; }
  /// Frees the factorised equations, nearly all of the memory. fieldAt() must not be called any more.
  void dropEquations();

 private:
  HeadModel head_;
  std::unique_ptr<BoundarySystem> system_;
};

/// Points of the cortex where the mesh gives a field.
struct ReachablePoints {
  Eigen::Matrix3Xd points_mm;
  std::vector<bool> is_moved;
};
/// Moves points that lie outside `innermost`, or nearer to it than 0.4 edges of its triangles (2 mm on top),
/// inwards to that depth: nearer to the surface the piecewise linear potential gives no field. In a fold that
/// is too thin for it they end near its middle.
ReachablePoints reachablePoints(const ShellMesh& innermost, const Eigen::Matrix3Xd& points_mm);

}  // namespace facenav::efield
