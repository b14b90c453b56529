#pragma once
// ErrorStatistics: a list of errors summed up as the tables state it. Unit: that of the input.

#include <vector>

namespace facenav::evaluation {

struct ErrorStatistics {
  int count = 0;
  double rms = 0, mean = 0, median = 0, p95 = 0, max = 0;
};

/// All zero with count 0 for an empty list. p95 is the smallest value with 95 % of all at or below it.
ErrorStatistics summarise(std::vector<double> errors);

/// The smallest value with `fraction` (0..1) of all at or below it; 0 for an empty list.
double quantile(std::vector<double> values, double fraction);

}  // namespace facenav::evaluation
