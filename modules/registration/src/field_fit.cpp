#include "field_fit.h"

#include <cmath>

namespace facenav::registration {
namespace {

constexpr float kGrazing_cos = 0.12f;      // skin seen flatter than this is no counterpart
constexpr float kNormalsAgree_cos = 0.3f;  // cloud normals are noisy: only gross disagreement counts
constexpr float kNoSkin_mm = 1e5f;
constexpr int kBlock = 64;

using Column = float[kBlock];

}  // namespace

struct FieldFitter::View {
  float r[3][3], t[3];  // t is also where the camera stands, Mri
  explicit View(const Eigen::Isometry3d& pose) {
    for (int i = 0; i < 3; ++i) {
      t[i] = float(pose.translation()[i]);
      for (int j = 0; j < 3; ++j) r[i][j] = float(pose.linear()(i, j));
    }
  }
};

/// Loops over it have no branches, so that compilers run four points at once.
struct FieldFitter::Block {
  int count = 0;
  Column at[3], normal[3], residual;
  Column is_valid;  // 1 or 0
};

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
    : scalp_(scalp), pivot_(scalp.middle_mm().cast<float>()) {
  const bool has_normals = cloud.normals.size() == cloud.size();
  for (int a = 0; a < 3; ++a) {
    points_[a].reserve(points.size());
    for (const int p : points) points_[a].push_back(float(cloud.points_mm[std::size_t(p)][a]));
    if (!has_normals) continue;
    normals_[a].reserve(points.size());
    for (const int p : points) normals_[a].push_back(float(cloud.normals[std::size_t(p)][a]));
  }
}

template <bool kIsFine>
void FieldFitter::measure(Block& block, std::size_t first, const View& view) const {
  const int n = block.count = int(std::min<std::size_t>(kBlock, size() - first));
  const float *x = &points_[0][first], *y = &points_[1][first], *z = &points_[2][first];
  for (int a = 0; a < 3; ++a)
    for (int i = 0; i < n; ++i)
      block.at[a][i] = view.r[a][0] * x[i] + view.r[a][1] * y[i] + view.r[a][2] * z[i] + view.t[a];
  for (int i = 0; i < n; ++i) {
    const Eigen::Vector3f query(block.at[0][i], block.at[1][i], block.at[2][i]);
    const FieldSample sample = kIsFine ? scalp_.fine(query) : scalp_.coarse(query);
    block.residual[i] = sample.distance_mm;
    block.normal[0][i] = sample.gradient.x();
    block.normal[1][i] = sample.gradient.y();
    block.normal[2][i] = sample.gradient.z();
  }
  for (int i = 0; i < n; ++i) {
    const float cx = view.t[0] - block.at[0][i], cy = view.t[1] - block.at[1][i],
                cz = view.t[2] - block.at[2][i];
    const float nx = block.normal[0][i], ny = block.normal[1][i], nz = block.normal[2][i];
    const float facing = nx * cx + ny * cy + nz * cz;
    const float least =
        kGrazing_cos * kGrazing_cos * (cx * cx + cy * cy + cz * cz) * (nx * nx + ny * ny + nz * nz);
    const float grazing = facing * std::abs(facing) > least ? 1.0f : 0.0f;
    block.is_valid[i] = block.residual[i] < kNoSkin_mm ? grazing : 0.0f;  // not a number: no skin
  }
  if (normals_[0].empty()) return;
  const float *u = &normals_[0][first], *v = &normals_[1][first], *w = &normals_[2][first];
  for (int i = 0; i < n; ++i) {
    float agree = 0.0f;
    for (int a = 0; a < 3; ++a)
      agree += block.normal[a][i] * (view.r[a][0] * u[i] + view.r[a][1] * v[i] + view.r[a][2] * w[i]);
    block.is_valid[i] = agree > kNormalsAgree_cos ? block.is_valid[i] : 0.0f;
  }
}

void FieldFitter::measure(Block& block, std::size_t first, const View& view, bool is_fine) const {
  if (is_fine)
    measure<true>(block, first, view);
  else
    measure<false>(block, first, view);
}

std::vector<PointMatch> FieldFitter::match(const Eigen::Isometry3d& mri_T_camera) const {
  const View view(mri_T_camera);
  std::vector<PointMatch> matches(size());
  Block block;
  for (std::size_t first = 0; first < size(); first += kBlock) {
    measure(block, first, view, true);
    for (int i = 0; i < block.count; ++i) {
      PointMatch& match = matches[first + std::size_t(i)];
      match.at_mri_mm = {block.at[0][i], block.at[1][i], block.at[2][i]};
      if (!(block.residual[i] < kNoSkin_mm)) continue;
      match.residual_mm = block.residual[i];
      match.normal_mri =
          Eigen::Vector3f(block.normal[0][i], block.normal[1][i], block.normal[2][i]).normalized();
      match.is_valid = block.is_valid[i] > 0;
    }
  }
  return matches;
}

namespace {

/// The normal equations of one step: lower triangle of the 7 x 7 products of (turn, normal, residual).
struct NormalEquations {
  Eigen::Matrix<double, 7, 7> products = Eigen::Matrix<double, 7, 7>::Zero();
  double total = 0.0;

  void add(const Column (&row)[7], const Column& weight) {
    constexpr int kLanes = 4;
    for (int r = 0; r < 7; ++r) {
      Column weighted;
      for (int i = 0; i < kBlock; ++i) weighted[i] = row[r][i] * weight[i];
      for (int c = 0; c <= r; ++c) {
        float lane[kLanes] = {};
        for (int i = 0; i < kBlock; i += kLanes)
          for (int l = 0; l < kLanes; ++l) lane[l] += weighted[i + l] * row[c][i + l];
        products(r, c) += double(lane[0] + lane[1] + lane[2] + lane[3]);
      }
    }
    for (int i = 0; i < kBlock; ++i) total += double(weight[i]);
  }

  /// The step (turn, shift) about the pivot. A whiff of damping keeps directions that the surface does not
  /// fix (a sphere's rotations) where they are.
  Vector6d step() const {
    Matrix6d matrix = products.topLeftCorner<6, 6>();
    matrix.diagonal().head<3>().array() += 1e-4 * total * 1e3;
    matrix.diagonal().tail<3>().array() += 1e-4 * total;
    return -matrix.selfadjointView<Eigen::Lower>().ldlt().solve(products.row(6).head<6>().transpose());
  }
};

}  // namespace

Eigen::Isometry3d FieldFitter::fit(Eigen::Isometry3d pose, const FitStage& stage) const {
  const float outside = 1.0f / stage.outside_mm, inside = 1.0f / stage.inside_mm;
  for (int iteration = 0; iteration < stage.iterations; ++iteration) {
    const View view(pose);
    NormalEquations sums;
    Block block;
    for (std::size_t first = 0; first < size(); first += kBlock) {
      measure(block, first, view, stage.is_fine);
      Column row[7], weight;
      for (int i = 0; i < block.count; ++i) {
        // Where there is no skin, residual and normal are no numbers: zero, not weighed by zero.
        const bool is_valid = block.is_valid[i] > 0;
        const float residual = is_valid ? block.residual[i] : 0.0f;
        const float u = residual * (residual > 0 ? outside : inside), v = std::max(0.0f, 1.0f - u * u);
        weight[i] = is_valid ? v * v : 0.0f;
        const float x = block.at[0][i] - pivot_[0], y = block.at[1][i] - pivot_[1],
                    z = block.at[2][i] - pivot_[2];
        const float nx = is_valid ? block.normal[0][i] : 0.0f, ny = is_valid ? block.normal[1][i] : 0.0f,
                    nz = is_valid ? block.normal[2][i] : 0.0f;
        row[0][i] = y * nz - z * ny, row[1][i] = z * nx - x * nz, row[2][i] = x * ny - y * nx;
        row[3][i] = nx, row[4][i] = ny, row[5][i] = nz, row[6][i] = residual;
      }
      if (!weights_.empty())
        for (int i = 0; i < block.count; ++i) weight[i] *= weights_[first + std::size_t(i)];
      for (int i = block.count; i < kBlock; ++i) {
        weight[i] = 0.0f;
        for (auto& r : row) r[i] = 0.0f;
      }
      sums.add(row, weight);
    }
    if (sums.total < 20) break;
    const Vector6d xi = sums.step();
    if (!xi.allFinite()) break;
    pose = increment(xi, pivot_.cast<double>(), pose);
    if (xi.head<3>().norm() < stage.settled_mm / 100.0 && xi.tail<3>().norm() < stage.settled_mm) break;
  }
  return pose;
}

double FieldFitter::cost(const Eigen::Isometry3d& mri_T_camera, double truncation_mm) const {
  const View view(mri_T_camera);
  const float limit = float(truncation_mm * truncation_mm), deep = 1.3f * limit;
  double sum = 0;
  Block block;
  for (std::size_t first = 0; first < size(); first += kBlock) {
    measure(block, first, view, false);
    for (int i = 0; i < block.count; ++i) {
      const float residual = block.residual[i];
      if (block.is_valid[i] > 0)
        sum += std::min(residual * residual, residual < 0 ? deep : limit);
      else
        sum += residual < -2 * float(truncation_mm) ? deep : limit;
    }
  }
  return size() == 0 ? limit : sum / double(size());
}

}  // namespace facenav::registration
