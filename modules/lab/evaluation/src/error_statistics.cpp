#include "facenav/evaluation/error_statistics.h"

#include <algorithm>
#include <cmath>

#include "facenav/core/robust_statistics.h"

namespace facenav::evaluation {

ErrorStatistics summarise(std::vector<double> errors) {
  ErrorStatistics s;
  s.count = int(errors.size());
  if (errors.empty()) return s;
  std::sort(errors.begin(), errors.end());
  double sum = 0, squares = 0;
  for (double e : errors) sum += e, squares += e * e;
  const double n = double(errors.size());
  s.mean = sum / n;
  s.rms = std::sqrt(squares / n);
  s.median = median(errors);
  s.p95 = errors[std::size_t(std::ceil(0.95 * n)) - 1];
  s.max = errors.back();
  return s;
}

double quantile(std::vector<double> values, double fraction) {
  if (values.empty()) return 0.0;
  const double rank =
      std::clamp(std::ceil(fraction * double(values.size())) - 1.0, 0.0, double(values.size() - 1));
  return selectRank(values, std::size_t(rank));
}

}  // namespace facenav::evaluation
