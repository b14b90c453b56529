#pragma once
// Tables and side files of NIBS-BIDS (BEP037): tab-separated, missing = "n/a", described by JSON files beside
// or above them (BIDS's inheritance: the nearest one whose entities the table has, too).

#include <optional>
#include <string>
#include <vector>

#include "facenav/core/json_reader.h"
#include "file_set.h"
#include "text.h"

namespace facenav::interop {

/// Rows of a .tsv. Cells are blank for "n/a".
class NibsTable {
 public:
  /// Throws Error naming the line: a row with more or fewer cells than the header.
  NibsTable(const FileSet& files, const std::string& name);
  std::size_t rows() const { return rows_.size(); }
  bool has(const std::string& column) const { return columns_.has(column); }
  std::string text(std::size_t row, const std::string& column) const;
  /// The number, or not-a-number for other text than "n/a"; nothing for a missing cell or column.
  std::optional<double> number(std::size_t row, const std::string& column) const;
  /// Three numbers of the columns beginning with `stem`, "target_"; nothing if all are missing.
  std::optional<Eigen::Vector3d> three(std::size_t row, const std::string& stem) const;
  /// "x_events.tsv, line 7".
  std::string where(std::size_t row) const;
  int line(std::size_t row) const { return lines_[row]; }

 private:
  std::string name_;
  Columns columns_;
  std::vector<std::vector<std::string>> rows_;
  std::vector<int> lines_;
};

/// The parts of "sub-01_task-rest_run-2_markers.tsv": entities and suffix.
struct NibsName {
  std::string folder, suffix;
  std::vector<std::string> entities;
  explicit NibsName(const std::string& name);
  /// The entity's value; empty if absent.
  std::string entity(const std::string& key) const;
  /// The name beside it with another suffix: "sub-01_task-rest_run-2_events.tsv".
  std::string beside(const std::string& suffix) const;
  /// The entities but the subject, as "task-rest_run-2".
  std::string words() const;
};

/// Side file for a table, with this ending ("coordsystem.json"), in its folder or one above; nothing if there
/// is none. Throws Error where it is damaged.
std::optional<JsonReader> nearestJson(const FileSet& files, const NibsName& table, const std::string& suffix);
/// Text of a member; empty if it is absent or no text.
std::string wordOf(const JsonReader& json, const std::string& key);
/// Number of a member, or in its text; nothing if it is absent or no number.
std::optional<double> numberOf(const JsonReader& json, const std::string& key);
/// Elements of a member that is a list or, in older files, a single object; empty if it is absent.
std::vector<JsonReader> listOf(const JsonReader& json, const std::string& key);

}  // namespace facenav::interop
