#include "facenav/interop/t1.h"

#include <Eigen/SVD>

#include "facenav/core/error.h"
#include "facenav/volume/nifti_forms.h"

namespace facenav::interop {
namespace {

/// Axis of the world that each axis of the voxels runs along best, and in which direction: as nibabel's
/// io_orientation decides it.
struct AxisOrder {
  std::array<int, 3> world{};
  std::array<int, 3> sign{};
};

AxisOrder axisOrder(const Eigen::Matrix3d& linear) {
  const Eigen::Matrix3d unit = linear * linear.colwise().norm().cwiseInverse().asDiagonal();
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(unit, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Matrix3d nearest = svd.matrixU() * svd.matrixV().transpose();
  AxisOrder order;
  for (int axis = 0; axis < 3; ++axis) {
    int world = 0;
    nearest.col(axis).cwiseAbs().maxCoeff(&world);
    order.world[std::size_t(axis)] = world;
    order.sign[std::size_t(axis)] = nearest(world, axis) < 0 ? -1 : 1;
    nearest.row(world).setZero();
  }
  return order;
}

}  // namespace

Eigen::Affine3d QformNumbers::affine() const {
  const Eigen::Vector3d v(quatern[0], quatern[1], quatern[2]);
  const double rest = 1.0 - v.squaredNorm();
  Eigen::Quaterniond q(rest > 1e-7 ? std::sqrt(rest) : 0.0, v.x(), v.y(), v.z());
  q.normalize();
  Eigen::Affine3d map = Eigen::Affine3d::Identity();
  map.linear() = q.toRotationMatrix() *
                 Eigen::Vector3d(pixdim[1], pixdim[2], pixdim[0] < 0 ? -pixdim[3] : pixdim[3]).asDiagonal();
  map.translation() << offset[0], offset[1], offset[2];
  return map;
}

const Eigen::Affine3d& T1::map(Form form) const {
  if (form == Form::any) return grid.mri_from_voxel;
  const auto& wanted = form == Form::sform ? sform : qform;
  if (!wanted)
    throw Error(std::string("the T1 has no ") + (form == Form::sform ? "sform" : "qform"), path.string(),
                "name the T1 that the other program used with --t1");
  return *wanted;
}

double T1::formsApart_mm() const { return sform && qform ? cornersApart_mm(*sform, *qform, grid.size) : 0.0; }

T1 readT1(const std::filesystem::path& path) {
  const auto forms = volume::readNiftiForms(path);
  return {path,        forms.grid,  forms.used,
          forms.sform, forms.qform, {forms.quatern, forms.offset, forms.pixdim}};
}

double cornersApart_mm(const Eigen::Affine3d& a, const Eigen::Affine3d& b, const std::array<int, 3>& size) {
  double worst_mm = 0;
  for (int corner = 0; corner < 8; ++corner) {
    Eigen::Vector3d ijk;
    for (int axis = 0; axis < 3; ++axis) ijk[axis] = (corner >> axis) & 1 ? size[std::size_t(axis)] - 1 : 0;
    worst_mm = std::max(worst_mm, (a * ijk - b * ijk).norm());
  }
  return worst_mm;
}

volume::VoxelGrid canonical(const volume::VoxelGrid& grid) {
  const AxisOrder order = axisOrder(grid.mri_from_voxel.linear());
  volume::VoxelGrid result;
  result.mri_from_voxel = grid.mri_from_voxel;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto to = std::size_t(order.world[axis]);
    result.size[to] = grid.size[axis];
    const Eigen::Vector3d step = grid.mri_from_voxel.linear().col(int(axis));
    result.mri_from_voxel.linear().col(int(to)) = order.sign[axis] * step;
    if (order.sign[axis] < 0) result.mri_from_voxel.translation() += step * (grid.size[axis] - 1);
  }
  return result;
}

volume::VoxelGrid canonicalOf(const Eigen::Affine3d& map, const volume::VoxelGrid& like) {
  const auto size = canonical(like).size;
  const AxisOrder order = axisOrder(map.linear());
  volume::VoxelGrid grid;
  grid.mri_from_voxel = map;
  for (std::size_t axis = 0; axis < 3; ++axis) grid.size[axis] = size[std::size_t(order.world[axis])];
  return canonical(grid);
}

}  // namespace facenav::interop
