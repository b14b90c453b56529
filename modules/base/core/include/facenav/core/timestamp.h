#pragma once
// Timestamp: a capture time. Live sources use the steady clock; recordings use the seconds in timestamps.csv.
// Only differences between timestamps of one source are meaningful.

#include <chrono>

namespace facenav {
inline namespace core {

struct Timestamp {
  double s = 0.0;

  static Timestamp now() {
    const auto since_epoch = std::chrono::steady_clock::now().time_since_epoch();
    return {std::chrono::duration<double>(since_epoch).count()};
  }
};

inline double operator-(Timestamp a, Timestamp b) { return a.s - b.s; }

}  // namespace core
}  // namespace facenav
