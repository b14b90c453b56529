#pragma once
// Time measurement for the benchmarks. One core: processor time with other threads switched off, independent
// of other programs. All cores: wall clock. Both report the fastest of several runs; for frame loops,
// distributions are reported.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <opencv2/core/utility.hpp>
#include <vector>

#include "facenav/core/parallel_for.h"
#include "facenav/core/processor_time.h"

namespace facenav::testing {

inline double wall_ms() {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

/// Fastest of `runs`, processor time, one thread.
inline double oneCore_ms(const std::function<void()>& work, int runs = 7) {
  const OneCoreOnly one_core;
  const int threads = cv::getNumThreads();
  cv::setNumThreads(1);
  double best_ms = 1e12;
  for (int i = 0; i < runs; ++i) {
    const double start_ms = processorTime_ms();
    work();
    best_ms = std::min(best_ms, processorTime_ms() - start_ms);
  }
  cv::setNumThreads(threads);
  return best_ms;
}

/// Fastest of `runs`, wall clock, all cores.
inline double allCores_ms(const std::function<void()>& work, int runs = 7) {
  const int threads = cv::getNumThreads();
  cv::setNumThreads(-1);
  double best_ms = 1e12;
  for (int i = 0; i < runs; ++i) {
    const double start_ms = wall_ms();
    work();
    best_ms = std::min(best_ms, wall_ms() - start_ms);
  }
  cv::setNumThreads(threads);
  return best_ms;
}

/// The smallest value such that `fraction` of all are at or below it (0.5: median, 0.99: p99); 0 for an empty
/// list.
inline double quantile(std::vector<double> values, double fraction) {
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  const auto rank = std::size_t(std::max(0.0, std::ceil(fraction * double(values.size())) - 1.0));
  return values[std::min(rank, values.size() - 1)];
}

}  // namespace facenav::testing
