#pragma once
// Medians, and a robust measure of spread. An odd count has one median. For an even count, `median` is the
// mean of the two middle values and `upperMedian` the larger one (the usual choice here: it is a value of the
// list and needs one selection). All return 0 for an empty list. Values must not be NaN.
// Source of the scale: a normal distribution's median absolute deviation is its sigma / 1.4826 (Rousseeuw and
// Croux 1993, Alternatives to the median absolute deviation).

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace facenav {
inline namespace core {

/// Sigma of a normal distribution per median absolute deviation.
constexpr double kSigmaPerMad = 1.4826;
/// Median length of a 2-D normal error, in its standard deviation.
constexpr double kMedianLength = 1.177;
/// Standard error of a median divided by that of a mean, for normal errors.
constexpr double kMedianNoise = 1.2533;
/// Reach of Tukey's biweight in sigmas: 95 % efficiency for normal errors (Huber 1981).
constexpr double kTukeyReach = 4.685;
/// Degrees of freedom of Student's t for residuals with outliers (Lange, Little, Taylor 1989).
constexpr double kStudentFreedom = 4.0;
/// Standard errors from which on a difference counts as one. Chance alone exceeds it once in 370 times.
constexpr double kSignificant = 3.0;

/// The value at `rank` (from 0) in sorted order; reorders `values`. A rank beyond the end means the last one.
/// 0 for an empty list.
template <class T>
T selectRank(std::vector<T>& values, std::size_t rank) {
  if (values.empty()) return T{};
  const auto at = values.begin() + std::ptrdiff_t(std::min(rank, values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// Value at `rank` as above; leaves `values` unchanged.
template <class T>
T valueAtRank(std::vector<T> values, std::size_t rank) {
  return selectRank(values, rank);
}

/// Median; for an even count, the larger of the two middle values.
template <class T>
T upperMedian(std::vector<T> values) {
  return selectRank(values, values.size() / 2);
}

/// Median; for an even count, the mean of the two middle values.
template <class T>
T median(std::vector<T> values) {
  if (values.size() % 2 == 1 || values.empty()) return upperMedian(std::move(values));
  const T upper = selectRank(values, values.size() / 2);
  const T lower = *std::max_element(values.begin(), values.begin() + std::ptrdiff_t(values.size() / 2));
  return (lower + upper) / 2;
}

/// The upper median of |value - middle|. Multiplied by kSigmaPerMad it estimates sigma, hardly changed by
/// outliers.
template <class T>
T medianAbsoluteDeviation(std::vector<T> values, T middle) {
  for (T& value : values) value = std::abs(value - middle);
  return upperMedian(std::move(values));
}

}  // namespace core
}  // namespace facenav
