#pragma once
// Rising edges of a serial port's input line, from the driver's count of changes and the line's level.

#include <optional>

namespace facenav::links {

struct LineReading {
  bool is_high = false;
  /// Changes of the line so far, both ways; nothing: the driver does not count them, and a pulse between two
  /// readings is missed.
  std::optional<int> changes;
};

/// Between two readings. Changes alternate, so the count and both levels give the number exactly.
int risingEdges(const LineReading& before, const LineReading& after);

}  // namespace facenav::links
