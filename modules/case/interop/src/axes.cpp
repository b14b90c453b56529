#include "facenav/interop/axes.h"

#include "facenav/core/error.h"

namespace facenav::interop {
namespace {

Eigen::Matrix3d columns(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  Eigen::Matrix3d matrix;
  matrix << a, b, c;
  return matrix;
}

Eigen::Matrix4d withRotation(Eigen::Matrix4d pose, const Eigen::Matrix3d& change) {
  pose.topLeftCorner<3, 3>() = (pose.topLeftCorner<3, 3>() * change).eval();
  return pose;
}

}  // namespace

const Eigen::Matrix3d& axesOf(CoilAxes axes) {
  static const Eigen::Vector3d x = Eigen::Vector3d::UnitX(), y = Eigen::Vector3d::UnitY(),
                               z = Eigen::Vector3d::UnitZ();
  static const Eigen::Matrix3d kFaceNav = columns(x, y, z);       // SimNIBS, ANT visor2, Slicer's nodes
  static const Eigen::Matrix3d kBrainsight = columns(-x, y, -z);  // and NaviNIBS: z out of the head
  static const Eigen::Matrix3d kLocalite = columns(z, -y, x);     // x into the head, y towards the grip
  static const Eigen::Matrix3d kSoftaxic = columns(y, -x, z);
  static const Eigen::Matrix3d kInvesalius = columns(y, x, -z);
  switch (axes) {
    case CoilAxes::facenav:
      return kFaceNav;
    case CoilAxes::brainsight:
      return kBrainsight;
    case CoilAxes::localite:
      return kLocalite;
    case CoilAxes::softaxic:
      return kSoftaxic;
    case CoilAxes::invesalius:
      return kInvesalius;
  }
  FACENAV_EXPECT(false, "unknown axes");
}

Eigen::Matrix4d toFaceNav(const Eigen::Matrix4d& theirs, CoilAxes axes) {
  return withRotation(theirs, axesOf(axes).transpose());
}

Eigen::Matrix4d fromFaceNav(const Eigen::Matrix4d& ours, CoilAxes axes) {
  return withRotation(ours, axesOf(axes));
}

Eigen::Matrix4d lpsFromRas() { return Eigen::Vector4d(-1, -1, 1, 1).asDiagonal(); }

}  // namespace facenav::interop
