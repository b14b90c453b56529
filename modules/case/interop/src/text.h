#pragma once
// Text of other programs' files: lines, cells, numbers, poses.

#include <Eigen/Core>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "facenav/interop/item.h"

namespace facenav::interop {

/// Why an item of a program has a place and no pose.
inline constexpr const char* kPlaceOnly =
    "a place only: how the axes of the program's coil lie is not documented";

/// Lines without their ends, LF or CRLF; a last line without an end counts.
std::vector<std::string> linesOf(const std::string& content);
/// Cells of a line, also empty ones.
std::vector<std::string> cellsOf(const std::string& line, char separator);
/// Cells of a line of CSV: in double quotes, these doubled inside.
std::vector<std::string> csvCellsOf(const std::string& line, char separator = ',');
/// A table whose cells a spreadsheet separated by semicolons or tabs, with commas between them and decimal
/// points in its numbers; nothing for other text.
std::optional<std::string> withCommas(const std::string& content);
/// True for a line of CSV that ends inside a quoted cell: it is cut short.
bool endsInQuotes(const std::string& line);
std::string trimmed(const std::string& text);
bool startsWith(const std::string& text, const std::string& beginning);
bool contains(const std::string& text, const std::string& word);

/// The number, or not-a-number for text that is none: a pose that holds it is refused by check().
double numberOrNan(const std::string& text);
/// A number of use; nothing for blank, "(null)", "NaN", "None".
std::optional<double> valueIn(const std::string& text);
/// Throws Error("<what>", "<file>, <where>").
[[noreturn]] void refuseFile(const std::filesystem::path& file, const std::string& where,
                             const std::string& what, const std::string& remedy = {});

/// Pose from 12 or 16 numbers, row by row.
Eigen::Matrix4d poseOfRows(const std::vector<double>& numbers);
/// Pose from origin and the columns of its rotation.
Eigen::Matrix4d poseOfColumns(const Eigen::Vector3d& origin, const Eigen::Vector3d& a,
                              const Eigen::Vector3d& b, const Eigen::Vector3d& c);
/// True for a rotation that is the identity: several programs write it where there is no pose.
bool isUnturned(const Eigen::Matrix4d& pose);

/// Number with this many decimals, without a sign at zero.
std::string plainFixed(double value, int decimals);
/// Seconds since 1970 of "2026-03-05" and "10:20:30.176"; nothing for other text.
std::optional<double> clockOf(const std::string& date, const std::string& time);
/// Sets the time of an item by "2026-03-05T10:20:30.176" or with a blank; other text changes nothing.
void setTime(const std::string& text, Item& item);
/// "2026-03-05" and "10:20:30.176" of seconds since 1970.
std::string dateOf(double clock_s);
std::string timeOf(double clock_s);

/// Columns of a table by their names.
class Columns {
 public:
  explicit Columns(const std::vector<std::string>& names);
  bool has(const std::string& name) const { return index_.count(name) > 0; }
  /// The cell; empty if the column or the cell is absent.
  std::string text(const std::vector<std::string>& cells, const std::string& name) const;
  double number(const std::vector<std::string>& cells, const std::string& name) const {
    return numberOrNan(text(cells, name));
  }
  const std::map<std::string, std::size_t>& index() const { return index_; }

 private:
  std::map<std::string, std::size_t> index_;
};

}  // namespace facenav::interop
