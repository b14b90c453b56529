#pragma once
// The axes of the coil in other programs' files: one table for reading and writing. Each program names its
// columns by the directions of FaceNav's Coil: x = y x z, y away from the handle, z into the head. Sources:
// the programs' own readers and files, see resources/doc/interop.md.

#include <Eigen/Core>

namespace facenav::interop {

enum class CoilAxes { facenav, brainsight, localite, softaxic, invesalius };

/// The program's axes as columns, in Coil: its rotation is ours times this matrix. Determinant +1.
const Eigen::Matrix3d& axesOf(CoilAxes axes);
/// Pose with FaceNav's axes from a file's pose. Only columns change; the world stays the file's.
Eigen::Matrix4d toFaceNav(const Eigen::Matrix4d& theirs, CoilAxes axes);
Eigen::Matrix4d fromFaceNav(const Eigen::Matrix4d& ours, CoilAxes axes);

/// The change between the worlds RAS and LPS, in both directions: x and y negated.
Eigen::Matrix4d lpsFromRas();

}  // namespace facenav::interop
