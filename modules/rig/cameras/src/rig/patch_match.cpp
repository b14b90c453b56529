#include "facenav/cameras/patch_match.h"
#include "facenav/geometry/normal_equations.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <array>
#include <cmath>

namespace facenav::cameras {
namespace {

constexpr int kHalf = 7, kSide = 2 * kHalf + 1, kPixels = kSide * kSide;
constexpr double kFarthestShift_px = 8.0, kLeastCorrelation = 0.85;
constexpr double kLeastTexture = 2.5;  // grey^2 per pixel^2, mean over the patch, in the weaker direction
constexpr double kFloor_px = 0.05;     // skin is not flat, and its shine moves

using Patch = Eigen::Matrix<double, kPixels, 1>;

/// Takes bilinear samples about `at`, `step` px apart (2: coarse level, means over 2 x 2); false outside the
/// image.
bool sample(const cv::Mat& image, const Eigen::Vector2d& at, int step, Patch& out) {
  const double left = at.x() - step * kHalf, top = at.y() - step * kHalf;
  const int x0 = int(std::floor(left)), y0 = int(std::floor(top));
  const int extent = step * (kSide - 1) + step;
  if (x0 < 0 || y0 < 0 || x0 + extent + 1 >= image.cols || y0 + extent + 1 >= image.rows) return false;
  const double fx = left - x0, fy = top - y0;
  for (int v = 0, i = 0; v < kSide; ++v)
    for (int u = 0; u < kSide; ++u, ++i) {
      double sum = 0;
      for (int dy = 0; dy < step; ++dy) {
        const std::uint8_t *row = image.ptr(y0 + step * v + dy) + x0 + step * u,
                           *next = image.ptr(y0 + step * v + dy + 1) + x0 + step * u;
        for (int dx = 0; dx < step; ++dx)
          sum += (1 - fy) * ((1 - fx) * row[dx] + fx * row[dx + 1]) +
                 fy * ((1 - fx) * next[dx] + fx * next[dx + 1]);
      }
      out[i] = sum / (step * step);
    }
  return true;
}

struct Template {
  Patch grey;
  Eigen::Matrix<double, kPixels, 2> gradient;  // per px of the full image
  Eigen::Matrix2d normal;
};

std::optional<Template> makeTemplate(const cv::Mat& left, const Eigen::Vector2d& at, int step) {
  Template made;
  Patch plus, minus;
  if (!sample(left, at, step, made.grey)) return std::nullopt;
  for (int axis = 0; axis < 2; ++axis) {
    const Eigen::Vector2d shift = step * Eigen::Vector2d::Unit(axis);
    if (!sample(left, at + shift, step, plus) || !sample(left, at - shift, step, minus)) return std::nullopt;
    made.gradient.col(axis) = (plus - minus) / (2.0 * step);
  }
  made.grey.array() -= made.grey.mean();
  for (int axis = 0; axis < 2; ++axis) {  // gain and offset are free: removes their part of the gradient
    made.gradient.col(axis).array() -= made.gradient.col(axis).mean();
    made.gradient.col(axis) -= made.grey * (made.grey.dot(made.gradient.col(axis)) / made.grey.squaredNorm());
  }
  made.normal = made.gradient.transpose() * made.gradient;
  return made;
}

/// Inverse compositional iterations. Returns the final correlation; `at` receives the position.
std::optional<double> refine(const Template& wanted, const cv::Mat& right, int step, int rounds,
                             Eigen::Vector2d& at) {
  Patch seen;
  double correlation = 0;
  for (int round = 0; round < rounds; ++round) {
    if (!sample(right, at, step, seen)) return std::nullopt;
    seen.array() -= seen.mean();
    const double squares = seen.squaredNorm(), product = wanted.grey.dot(seen);
    if (!(squares > 0) || !(product > 0)) return std::nullopt;
    correlation = product / std::sqrt(squares * wanted.grey.squaredNorm());
    const double gain = wanted.grey.squaredNorm() / product;
    const Eigen::Vector2d move =
        solveSymmetric(wanted.normal, Eigen::Vector2d(wanted.gradient.transpose() * (gain * seen)));
    at -= move;
    if (!move.allFinite() || move.norm() > 3.0 * step) return std::nullopt;
    if (move.norm() < 0.01) break;
  }
  return correlation;
}

}  // namespace

std::optional<PatchMatch> matchPatch(const cv::Mat& left, const cv::Mat& right,
                                     const Eigen::Vector2d& left_px, const Eigen::Vector2d& right_start_px) {
  const auto fine = makeTemplate(left, left_px, 1);
  if (!fine) return std::nullopt;
  const double texture = principalAxes(fine->normal).values[0];
  if (!(texture > kLeastTexture * kPixels)) return std::nullopt;
  Eigen::Vector2d at = right_start_px;
  auto correlation = refine(*fine, right, 1, 8, at);
  if (!correlation || *correlation < kLeastCorrelation) {  // too far for the fine level
    at = right_start_px;
    const auto coarse = makeTemplate(left, left_px, 2);
    if (!coarse || !refine(*coarse, right, 2, 6, at)) return std::nullopt;
    correlation = refine(*fine, right, 1, 8, at);
  }
  if (!correlation || *correlation < kLeastCorrelation || (at - right_start_px).norm() > kFarthestShift_px)
    return std::nullopt;
  const double residual2 = (1 - *correlation * *correlation) * fine->grey.squaredNorm() / kPixels;
  return PatchMatch{at, *correlation, std::sqrt(kFloor_px * kFloor_px + 4.0 * residual2 / texture)};
}

}  // namespace facenav::cameras
