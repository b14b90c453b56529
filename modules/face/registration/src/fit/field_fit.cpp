#include "field_fit.h"
#include "facenav/geometry/normal_equations.h"

#include <cmath>

namespace facenav::registration {
namespace {

using point::Block;
using point::kBlock;

point::View viewFrom(const Eigen::Isometry3d& pose) {
  point::View view;
  for (int i = 0; i < 3; ++i) {
    view.t[i] = float(pose.translation()[i]);
    for (int j = 0; j < 3; ++j) view.r[i][j] = float(pose.linear()(i, j));
  }
  return view;
}

std::size_t padded(std::size_t size) { return (size + kBlock - 1) / kBlock * kBlock; }

}  // namespace

Eigen::Isometry3d increment(const Vector6d& xi, const Eigen::Vector3d& pivot, const Eigen::Isometry3d& pose) {
  const Eigen::Isometry3d step = expRigid(xi);
  Eigen::Isometry3d moved = Eigen::Isometry3d::Identity();
  moved.linear() = step.linear() * pose.linear();
  moved.translation() = step.linear() * (pose.translation() - pivot) + pivot + step.translation();
  return moved;
}

bool areDistinct(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b, const Eigen::Vector3d& pivot_mri_mm,
                 double rotation_rad, double distance_mm) {
  const Eigen::Isometry3d change = a * b.inverse();
  return rotationAngle(change.linear()) > rotation_rad ||
         (change * pivot_mri_mm - pivot_mri_mm).norm() > distance_mm;
}

FieldFitter::FieldFitter(const ScalpField& scalp, const PointCloud<Camera>& cloud,
                         const std::vector<int>& points)
    : scalp_(scalp), pivot_(scalp.middle_mm().cast<float>()), count_(points.size()) {
  constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
  const bool has_normals = cloud.normals.size() == cloud.size();
  for (int a = 0; a < 3; ++a) {
    points_[a].reserve(padded(count_));
    for (const int p : points) points_[a].push_back(float(cloud.points_mm[std::size_t(p)][a]));
    points_[a].resize(padded(count_), kNone);
    if (!has_normals) continue;
    normals_[a].reserve(padded(count_));
    for (const int p : points) normals_[a].push_back(float(cloud.normals[std::size_t(p)][a]));
    normals_[a].resize(padded(count_), kNone);
  }
}

void FieldFitter::setWeights(std::vector<float> weights) {
  weights_ = std::move(weights);
  if (!weights_.empty()) weights_.resize(padded(count_), 0.0f);
}

point::Points FieldFitter::points() const {
  point::Points points;
  for (int a = 0; a < 3; ++a) {
    points.at_mm[a] = points_[a].data();
    points.normal[a] = normals_[a].empty() ? nullptr : normals_[a].data();
  }
  points.weight = weights_.empty() ? nullptr : weights_.data();
  return points;
}

template <class Visitor>
void FieldFitter::measure(const Eigen::Isometry3d& mri_T_camera, bool is_fine, Visitor&& visit) const {
  const point::View view = viewFrom(mri_T_camera);
  const point::Points from = points();
  const point::Kernel& kernel = point::kernel();
  Block block;
  for (std::size_t first = 0; first < count_; first += kBlock) {
    const int count = int(std::min<std::size_t>(kBlock, count_ - first));
    kernel.measure(scalp_.grids(), from, int(first), count, view, is_fine, block);
    visit(block, first);
  }
}

std::vector<PointMatch> FieldFitter::match(const Eigen::Isometry3d& mri_T_camera) const {
  std::vector<PointMatch> matches(size());
  measure(mri_T_camera, true, [&](const Block& block, std::size_t first) {
    for (int i = 0; i < block.count; ++i) {
      PointMatch& match = matches[first + std::size_t(i)];
      match.at_mri_mm = {block.at_mm[0][i], block.at_mm[1][i], block.at_mm[2][i]};
      if (!(block.residual_mm[i] < point::kNoSkin_mm)) continue;
      match.residual_mm = block.residual_mm[i];
      match.normal_mri =
          Eigen::Vector3f(block.normal[0][i], block.normal[1][i], block.normal[2][i]).normalized();
      match.is_valid = block.is_valid[i] > 0;
    }
  });
  return matches;
}

namespace {

/// The normal equations of one step: lower triangle of the 7 x 7 products of (turn, normal, residual).
struct NormalEquations {
  Eigen::Matrix<double, 7, 7> products = Eigen::Matrix<double, 7, 7>::Zero();
  double total = 0.0;

  void add(const point::Sums& sums) {
    const float* product = sums.products;
    for (int r = 0; r < 7; ++r)
      for (int c = 0; c <= r; ++c) products(r, c) += double(*product++);
    total += double(sums.weight);
  }

  /// The step (turn, shift) about the pivot. A small damping keeps directions that the surface does not fix
  /// (rotations of a sphere) unchanged.
  Vector6d step() const {
    Matrix6d matrix = products.topLeftCorner<6, 6>();
    matrix.diagonal().head<3>().array() += 1e-4 * total * 1e3;
    matrix.diagonal().tail<3>().array() += 1e-4 * total;
    return -solveSymmetric(Matrix6d(matrix.selfadjointView<Eigen::Lower>()),
                           Vector6d(products.row(6).head<6>()));
  }
};

}  // namespace

Eigen::Isometry3d FieldFitter::fit(Eigen::Isometry3d pose, const FitStage& stage) const {
  const point::Loss loss{stage.inside_mm, stage.outside_mm, {pivot_[0], pivot_[1], pivot_[2]}};
  const point::Points from = points();
  for (int iteration = 0; iteration < stage.iterations; ++iteration) {
    NormalEquations sums;
    measure(pose, stage.is_fine, [&](const Block& block, std::size_t first) {
      sums.add(point::kernel().sum(block, from, int(first), loss));
    });
    if (sums.total < 20) break;
    const Vector6d xi = sums.step();
    if (!xi.allFinite()) break;
    pose = increment(xi, pivot_.cast<double>(), pose);
    if (xi.head<3>().norm() < stage.settled_mm / 100.0 && xi.tail<3>().norm() < stage.settled_mm) break;
  }
  return pose;
}

std::vector<int> FieldFitter::within(const Eigen::Isometry3d& mri_T_camera, double reach_mm) const {
  std::vector<int> near;
  near.reserve(size());
  measure(mri_T_camera, false, [&](const Block& block, std::size_t first) {
    for (int i = 0; i < block.count; ++i)
      if (std::abs(block.residual_mm[i]) < float(reach_mm)) near.push_back(int(first) + i);
  });
  return near;
}

double FieldFitter::cost(const Eigen::Isometry3d& mri_T_camera, double truncation_mm) const {
  const float limit = float(truncation_mm * truncation_mm), deep = 1.3f * limit;
  double sum = 0;
  measure(mri_T_camera, false, [&](const Block& block, std::size_t) {
    for (int i = 0; i < block.count; ++i) {
      const float residual = block.residual_mm[i];
      if (block.is_valid[i] > 0)
        sum += std::min(residual * residual, residual < 0 ? deep : limit);
      else
        sum += residual < -2 * float(truncation_mm) ? deep : limit;
    }
  });
  return size() == 0 ? limit : sum / double(size());
}

}  // namespace facenav::registration
