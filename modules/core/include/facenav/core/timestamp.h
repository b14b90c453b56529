#pragma once
// Timestamp: a capture time. Live sources stamp frames with the steady clock; recordings carry seconds from
// timestamps.csv. Only differences of stamps from one source mean anything.

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
