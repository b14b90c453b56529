#include "affine_fit.h"

#include <Eigen/Cholesky>

namespace facenav::atlas {
namespace {

using Matrix12 = Eigen::Matrix<double, 12, 12>;
using Vector12 = Eigen::Matrix<double, 12, 1>;

struct NormalEquations {
  Matrix12 left = Matrix12::Zero();
  Vector12 right = Vector12::Zero();

  void add(const Eigen::Vector3f& gradient, const Eigen::Vector3d& at_mm, double difference, double weight) {
    Vector12 row;  // d(moving)/d(M, t), where x -> x + M x + t
    for (int c = 0; c < 3; ++c)
      for (int r = 0; r < 3; ++r) row[3 * c + r] = gradient[r] * at_mm[c];
    for (int r = 0; r < 3; ++r) row[9 + r] = gradient[r];
    left.selfadjointView<Eigen::Lower>().rankUpdate(row, weight);
    right += weight * difference * row;
  }
};

/// Huber's weight, so that tissue without a counterpart does not affect the fit.
double robustWeight(double difference) {
  const double size = std::abs(difference);
  return size < 1.0 ? 1.0 : 1.0 / size;
}

NormalEquations linearise(const BrainPair& pair, const Channels& moving, const Eigen::Vector3d& centre_mm) {
  const auto& grid = pair.grid();
  const double spacing_mm = grid.spacing_mm()[0];
  NormalEquations sum;
  for (int k = 0; k < grid.size[2]; ++k)
    for (int j = 0; j < grid.size[1]; ++j)
      for (int i = 0; i < grid.size[0]; ++i) {
        const std::size_t n = moving.t1.index(i, j, k);
        const Eigen::Vector3d at_mm = grid.mri_from_voxel * Eigen::Vector3d(i, j, k) - centre_mm;
        const double brain = pair.fixed().brain.values[n] - moving.brain.values[n];
        const Eigen::Vector3f brain_slope = gradientAt(moving.brain, i, j, k) / float(spacing_mm);
        if (!brain_slope.isZero()) sum.add(brain_slope, at_mm, brain, kBrainWeight);
        if (pair.fixed().t1.values[n] == 0 || moving.t1.values[n] == 0) continue;
        const double t1 = pair.fixed().t1.values[n] - moving.t1.values[n];
        sum.add(gradientAt(moving.t1, i, j, k) / float(spacing_mm), at_mm, t1, robustWeight(t1));
      }
  return sum;
}

Eigen::Affine3d toAffine(const Vector12& step, const Eigen::Vector3d& centre_mm) {
  Eigen::Affine3d change = Eigen::Affine3d::Identity();
  change.linear() += Eigen::Map<const Eigen::Matrix3d>(step.data());
  change.translation() = step.tail<3>();
  return Eigen::Translation3d(centre_mm) * change * Eigen::Translation3d(-centre_mm);
}

}  // namespace

Eigen::Affine3d affineFromMoments(const BrainPair& pair) {
  const auto from = pair.templateMoments(), to = pair.patientMoments();
  const Eigen::Vector3d scale = to.deviation_mm.cwiseQuotient(from.deviation_mm).cwiseMax(0.6).cwiseMin(1.5);
  return Eigen::Translation3d(to.centre_mm) * Eigen::Scaling(scale) * Eigen::Translation3d(-from.centre_mm);
}

double cost(const BrainPair& pair, const Channels& moving) {
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t n = 0; n < moving.t1.values.size(); ++n) {
    const double brain = pair.fixed().brain.values[n] - moving.brain.values[n];
    const double t1 = pair.fixed().t1.values[n] - moving.t1.values[n];
    const bool is_either = pair.fixed().brain.values[n] > 0.5f || moving.brain.values[n] > 0.5f;
    if (!is_either) continue;
    sum += kBrainWeight * brain * brain +
           std::min(t1 * t1, 2 * std::abs(t1) - 1 > 0 ? 2 * std::abs(t1) - 1 : t1 * t1);
    ++count;
  }
  return count ? sum / double(count) : HUGE_VAL;
}

Eigen::Affine3d fitAffine(const BrainPair& pair, const Eigen::Affine3d& start, int iterations) {
  const Eigen::Vector3d centre_mm = pair.templateMoments().centre_mm;
  Eigen::Affine3d best = start;
  double best_cost = cost(pair, pair.warped(start, nullptr)), damping = 1e-3;
  for (int i = 0; i < iterations; ++i) {
    const auto equations = linearise(pair, pair.warped(best, nullptr), centre_mm);
    bool is_better = false;
    double moved_mm = 0;
    for (int attempt = 0; attempt < 4 && !is_better; ++attempt) {
      Matrix12 left = equations.left.selfadjointView<Eigen::Lower>();
      left.diagonal() *= 1 + damping;
      const Vector12 step = left.ldlt().solve(equations.right);
      const Eigen::Affine3d candidate = best * toAffine(step, centre_mm);
      const double candidate_cost = cost(pair, pair.warped(candidate, nullptr));
      is_better = candidate_cost < best_cost;
      damping *= is_better ? 0.3 : 10;
      if (!is_better) continue;
      moved_mm = step.tail<3>().norm() + 70.0 * step.head<9>().norm();  // 70 mm: half extent of a brain
      best = candidate;
      best_cost = candidate_cost;
    }
    if (!is_better || moved_mm < 0.02) break;
  }
  return best;
}

}  // namespace facenav::atlas
