#pragma once
// Properties of a target besides its pose: who changed it and when, its position in a grid of targets, and
// the session that its pose comes from.

#include <optional>
#include <string>

namespace facenav::guidance {

/// One change of a target.
struct Change {
  std::string utc;   // 2026-11-23T14:05:09.123Z
  std::string by;    // who made it; empty: unknown
  std::string what;  // "planned", "moved", "handle turned"
};

/// Origin of a target that was not planned: the pose at which an expert held the coil in a session.
struct ExpertPose {
  std::string session;                   // its name
  int pulses = 1;                        // number of pulses; the pose is their median
  double spread_mm = 0, spread_deg = 0;  // medians of the pulses' distance and angle from the pose
  double predicted_error_mm = 0;         // standard error predicted by the session's alignment; 0: unknown
  std::string coil;                      // its name; empty: unknown
};

enum class GridOn { scalp, cortex };

/// A grid of targets round a seed, which is its centre.
struct GridSpec {
  int rows = 5, columns = 5;  // rows lie one behind the other along the handle, columns beside each other
  double spacing_mm = 7.5;    // measured on the scalp as with a tape, or on the brain's hull
  GridOn on = GridOn::scalp;

  bool operator==(const GridSpec& other) const {
    return rows == other.rows && columns == other.columns && spacing_mm == other.spacing_mm && on == other.on;
  }
};

/// Position of a target that belongs to a grid.
struct GridPlace {
  std::string seed;         // name of the target that it belongs to
  int row = 1, column = 1;  // from 1; row 1 is the foremost, column 1 the leftmost seen from above the coil
  bool is_edited = false;   // edited by hand: it does not move with the seed
};

}  // namespace facenav::guidance
