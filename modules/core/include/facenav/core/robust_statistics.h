#pragma once
// Medians and what rests on them. Which median: of an odd count there is one. Of an even count, `median` is
// the mean of both middle values, `upperMedian` the larger of them (the usual choice here: it is a value of
// the list and costs one selection). Of an empty list all are 0. Values must not be NaN.
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

/// The value that stands at `rank` (from 0) when sorted; `values` comes back in another order. 0 for an empty
/// list; a rank beyond the end is the last one.
template <class T>
T selectRank(std::vector<T>& values, std::size_t rank) {
  if (values.empty()) return T{};
  const auto at = values.begin() + std::ptrdiff_t(std::min(rank, values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// The same of a copy.
template <class T>
T valueAtRank(std::vector<T> values, std::size_t rank) {
  return selectRank(values, rank);
}

/// The larger middle value of an even count.
template <class T>
T upperMedian(std::vector<T> values) {
  return selectRank(values, values.size() / 2);
}

/// The mean of both middle values of an even count.
template <class T>
T median(std::vector<T> values) {
  if (values.size() % 2 == 1 || values.empty()) return upperMedian(std::move(values));
  const T upper = selectRank(values, values.size() / 2);
  const T lower = *std::max_element(values.begin(), values.begin() + std::ptrdiff_t(values.size() / 2));
  return (lower + upper) / 2;
}

/// The upper median of |value - middle|; times kSigmaPerMad it is a sigma that outliers hardly change.
template <class T>
T medianAbsoluteDeviation(std::vector<T> values, T middle) {
  for (T& value : values) value = std::abs(value - middle);
  return upperMedian(std::move(values));
}

}  // namespace core
}  // namespace facenav
