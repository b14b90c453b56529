#include "patch_filters.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace facenav::head_tracking {
namespace {

using patch::kSamples;
using patch::kSide;
using MatrixS = Eigen::Matrix<float, kSamples, kSamples>;
using VectorS = Eigen::Matrix<float, kSamples, 1>;

constexpr double kSmooth_px = 6.0;   // distance over which most of the shading is correlated
constexpr double kFineShare = 0.04;  // fraction of its variance at the finer scale
// White variance of the error of bilinear sampling, relative to the sensor's. Without it the filters would
// amplify detail lost to blur.
constexpr double kSampling = 0.03;

Eigen::MatrixXd separable(const std::array<double, kSide>& along) {
  Eigen::MatrixXd k(kSamples, kSamples);
  for (int i = 0; i < kSamples; ++i)
    for (int j = 0; j < kSamples; ++j)
      k(i, j) = along[std::size_t(std::abs(i % kSide - j % kSide))] *
                along[std::size_t(std::abs(i / kSide - j / kSide))];
  return k;
}

std::array<double, kSide> smoothOver(double length_px) {
  std::array<double, kSide> c;
  for (int lag = 0; lag < kSide; ++lag) c[lag] = std::exp(-0.5 * std::pow(lag / length_px, 2));
  return c;
}

// Basis in which noise has unit variance and shading the variance `shading`, all independent.
struct Base {
  MatrixS vectors;
  VectorS shading;

  explicit Base(int level) {
    const Eigen::MatrixXd noise =
        separable(noiseCorrelation(level)) + kSampling * Eigen::MatrixXd::Identity(kSamples, kSamples);
    const Eigen::MatrixXd smooth = (1 - kFineShare) * separable(smoothOver(kSmooth_px)) +
                                   kFineShare * separable(smoothOver(kFineShading_px));
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(smooth, noise);
    vectors = solver.eigenvectors().cast<float>();
    shading = solver.eigenvalues().cwiseMax(0.0).cast<float>();
  }
};

const Base& baseOf(int level) {
  static const Base finest(0), halved(1);
  return level == 0 ? finest : halved;
}

}  // namespace

const Eigen::Matrix<float, kSamples, kSamples, Eigen::RowMajor>& patternsByFineness() {
  static const Eigen::Matrix<float, kSamples, kSamples, Eigen::RowMajor> patterns =
      baseOf(0).vectors.transpose();
  return patterns;
}

std::array<double, kSide> noiseCorrelation(int level) {
  std::array<double, kSide> c{};
  if (level == 0) c = {70, 56, 28, 8, 1};
  if (level > 0) c = {70, 28, 1};
  for (double& value : c) value /= 256.0;
  return c;
}

std::array<std::vector<float>, 2> displacementFilters(const std::vector<float>& grey,
                                                      const std::vector<float>& d_u,
                                                      const std::vector<float>& d_v, int level,
                                                      double noise_grey, double shading_grey) {
  const Base& base = baseOf(level);
  const float ratio = float(std::pow(shading_grey / noise_grey, 2));
  Eigen::Matrix<float, kSamples, 4> columns;
  columns.col(0).setOnes();
  columns.col(1) = Eigen::Map<const VectorS>(grey.data());
  columns.col(2) = Eigen::Map<const VectorS>(d_u.data());
  columns.col(3) = Eigen::Map<const VectorS>(d_v.data());
  const VectorS weights = (1.f + ratio * base.shading.array()).inverse().matrix();
  const Eigen::Matrix<float, kSamples, 4> weighted =
      base.vectors * (weights.asDiagonal() * (base.vectors.transpose() * columns)).eval();
  const auto nuisance = columns.leftCols<2>();
  const Eigen::Matrix2f between = nuisance.transpose() * weighted.leftCols<2>();
  const Eigen::Matrix2f share = between.inverse() * (nuisance.transpose() * weighted.rightCols<2>());
  Eigen::Matrix<float, kSamples, 2> filters = weighted.rightCols<2>() - weighted.leftCols<2>() * share;
  std::array<std::vector<float>, 2> result;
  const float scale = columns.rightCols<2>().norm() / std::max(1e-9f, filters.norm());
  for (int k = 0; k < 2; ++k) {
    const VectorS filter = scale * filters.col(k);
    result[std::size_t(k)].assign(filter.data(), filter.data() + kSamples);
  }
  return result;
}

}  // namespace facenav::head_tracking
