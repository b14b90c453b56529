#pragma once
// Reads one run of NIBS-BIDS: what the side files of its markers.tsv say of units and strengths, and when it
// began.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "facenav/interop/item.h"
#include "nibs_table.h"

namespace facenav::interop {

/// What the side files of one markers.tsv say.
struct NibsRun {
  const FileSet& files;
  NibsName name;
  std::string markers;
  double mm_per_unit = 1;
  std::optional<JsonReader> coordsystem, nibs;

  /// Throws Error for a run whose unit is not stated, or stated twice.
  NibsRun(const FileSet& all, const std::string& markers_name);
};

/// Parts of a cell with '|' between them; one blank part for a blank cell.
std::vector<std::string> partsOf(const std::string& cell);

/// Strengths of the kinds of pulses, as % of the stimulator's output.
class NibsStrengths {
 public:
  explicit NibsStrengths(const NibsRun& run);
  /// Sets what nibs.tsv says of the kind, for one of the event's elements.
  void describe(const std::string& kind, std::size_t element, Item& item) const;

 private:
  std::optional<NibsTable> table_;
  std::map<std::string, std::size_t> rows_;
  std::map<std::string, double> references_;
  std::string unit_;
};

/// Start of a run by scans.tsv, s since 1970; nothing if there is none, or for a date that was moved before
/// 1925 to hide it.
std::optional<double> startOf(const NibsRun& run);

}  // namespace facenav::interop
