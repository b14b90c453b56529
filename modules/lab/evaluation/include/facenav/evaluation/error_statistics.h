#pragma once
// ErrorStatistics: summary of a list of errors, as given in the tables. Unit: that of the input.

#include <vector>

namespace facenav::evaluation {

struct ErrorStatistics {
  int count = 0;
  double rms = 0, mean = 0, median = 0, p95 = 0, max = 0;
};

/// Summarises errors; count 0 and all values 0 for an empty list. p95: the smallest value such that 95 % of
/// all are at or below it.
ErrorStatistics summarise(std::vector<double> errors);

/// Smallest value such that `fraction` (0..1) of all are at or below it; 0 for an empty list.
double quantile(std::vector<double> values, double fraction);

}  // namespace facenav::evaluation
