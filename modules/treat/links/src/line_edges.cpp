#include "line_edges.h"

namespace facenav::links {

int risingEdges(const LineReading& before, const LineReading& after) {
  const int step = int(after.is_high) - int(before.is_high);
  if (!before.changes || !after.changes) return step > 0 ? 1 : 0;
  const int changes = *after.changes - *before.changes;
  return changes > 0 ? (changes + step) / 2 : 0;
}

}  // namespace facenav::links
