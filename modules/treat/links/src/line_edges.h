#pragma once
// Rising edges of a serial port's input line, from the driver's count of changes and the line's level.

#include <optional>

namespace facenav::links {

struct LineReading {
  bool is_high = false;
  /// Number of level changes so far, in both directions. Nothing if the driver does not count them; a pulse
  /// between two readings is then missed.
  std::optional<int> changes;
};

/// Number of rising edges between two readings. It is exact, because levels alternate between changes.
int risingEdges(const LineReading& before, const LineReading& after);

}  // namespace facenav::links
