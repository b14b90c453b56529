#pragma once
// JSON on standard output: what `--json` of a verb prints.

#include <Eigen/Core>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

namespace facenav::app {

/// Prints one value, indented by one blank. Text that is no UTF-8 is replaced.
inline void printJson(const nlohmann::ordered_json& json) {
  std::printf("%s\n", json.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace).c_str());
}

/// Prints one value on a line of its own, at once: what a running session tells another program.
inline void printJsonLine(const nlohmann::ordered_json& json) {
  std::printf("%s\n", json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace).c_str());
  std::fflush(stdout);
}

inline double tenth(double value) { return std::round(10 * value) / 10 + 0.0; }
inline nlohmann::ordered_json tenths(const Eigen::Vector3d& p) {
  return {tenth(p.x()), tenth(p.y()), tenth(p.z())};
}

}  // namespace facenav::app
