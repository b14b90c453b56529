#include "text.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "facenav/core/csv_table.h"
#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "facenav/core/utc_time.h"

namespace facenav::interop {

std::vector<std::string> linesOf(const std::string& content) {
  std::vector<std::string> lines;
  for (std::size_t begin = 0; begin < content.size();) {
    std::size_t end = content.find('\n', begin);
    if (end == std::string::npos) end = content.size();
    const bool has_cr = end > begin && content[end - 1] == '\r';
    lines.push_back(content.substr(begin, end - begin - (has_cr ? 1 : 0)));
    begin = end + 1;
  }
  return lines;
}

std::vector<std::string> cellsOf(const std::string& line, char separator) {
  std::vector<std::string> cells(1);
  for (const char c : line) {
    if (c == separator)
      cells.emplace_back();
    else
      cells.back() += c;
  }
  return cells;
}

std::vector<std::string> csvCellsOf(const std::string& line, char separator) {
  std::vector<std::string> cells(1);
  bool is_quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (is_quoted && c == '"' && i + 1 < line.size() && line[i + 1] == '"')
      cells.back() += line[++i];
    else if (c == '"')
      is_quoted = !is_quoted;
    else if (c == separator && !is_quoted)
      cells.emplace_back();
    else
      cells.back() += c;
  }
  return cells;
}

std::optional<std::string> withCommas(const std::string& content) {
  constexpr int kLeastCells = 5;  // of the first line: a kind and a place, at least
  const auto lines = linesOf(content);
  if (lines.empty()) return std::nullopt;
  const auto separatorsIn = [&](char c) { return std::count(lines[0].begin(), lines[0].end(), c); };
  const char separator = separatorsIn(';') > separatorsIn('\t') ? ';' : '\t';
  if (separatorsIn(separator) + 1 < kLeastCells) return std::nullopt;
  std::string table;
  for (const auto& line : lines) {
    bool is_first = true;
    for (const auto& cell : csvCellsOf(line, separator)) {
      std::string point = cell;
      std::replace(point.begin(), point.end(), ',', '.');
      table += (std::exchange(is_first, false) ? "" : ",") + csvField(valueIn(point) ? point : cell);
    }
    table += "\n";
  }
  return table;
}

bool endsInQuotes(const std::string& line) { return std::count(line.begin(), line.end(), '"') % 2 != 0; }

std::string trimmed(const std::string& text) {
  const auto begin = text.find_first_not_of(" \t\r\n");
  if (begin == std::string::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t\r\n") - begin + 1);
}

bool startsWith(const std::string& text, const std::string& beginning) {
  return text.compare(0, beginning.size(), beginning) == 0;
}

bool contains(const std::string& text, const std::string& word) {
  return text.find(word) != std::string::npos;
}

double numberOrNan(const std::string& text) {
  return numberIn(trimmed(text)).value_or(std::numeric_limits<double>::quiet_NaN());
}

std::optional<double> valueIn(const std::string& text) { return numberIn(trimmed(text)); }

void refuseFile(const std::filesystem::path& file, const std::string& where, const std::string& what,
                const std::string& remedy) {
  throw Error(what, file.string() + (where.empty() ? "" : ", " + where), remedy);
}

Eigen::Matrix4d poseOfRows(const std::vector<double>& numbers) {
  FACENAV_EXPECT(numbers.size() == 12 || numbers.size() == 16, "a pose has 12 or 16 numbers");
  Eigen::Matrix4d pose = Eigen::Matrix4d::Identity();
  for (std::size_t i = 0; i < numbers.size(); ++i)
    pose(Eigen::Index(i / 4), Eigen::Index(i % 4)) = numbers[i];
  return pose;
}

Eigen::Matrix4d poseOfColumns(const Eigen::Vector3d& origin, const Eigen::Vector3d& a,
                              const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  Eigen::Matrix4d pose = Eigen::Matrix4d::Identity();
  pose.topLeftCorner<3, 3>() << a, b, c;
  pose.topRightCorner<3, 1>() = origin;
  return pose;
}

bool isUnturned(const Eigen::Matrix4d& pose) {
  return (pose.topLeftCorner<3, 3>() - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() < 1e-9;
}

std::string plainFixed(double value, int decimals) {
  std::string text = fixed(value, decimals);
  if (text.find_first_not_of("-0.") == std::string::npos && text[0] == '-') text.erase(0, 1);
  return text;
}

std::optional<double> clockOf(const std::string& date, const std::string& time) {
  std::string day = trimmed(date), clock = trimmed(time);
  if (day.size() != 10 || clock.size() < 8) return std::nullopt;
  if (clock.size() == 8) clock += ".000";
  clock.resize(12, '0');  // milliseconds
  return secondsOfUtc(day + "T" + clock + "Z");
}

void setTime(const std::string& text, Item& item) {
  if (text.size() < 19 || text[4] != '-' || text[7] != '-' || text[13] != ':') return;
  const std::string time = text.substr(11, text.find_first_of("Z+", 11) - 11);
  item.time = text.substr(0, 10) + " " + time;
  item.clock_s = clockOf(text.substr(0, 10), time);
}

namespace {
std::string isoOf(double clock_s) {
  using std::chrono::milliseconds;
  return isoUtc(std::chrono::system_clock::time_point(milliseconds(std::llround(clock_s * 1000.0))));
}
}  // namespace

std::string dateOf(double clock_s) { return isoOf(clock_s).substr(0, 10); }
std::string timeOf(double clock_s) { return isoOf(clock_s).substr(11, 12); }

Columns::Columns(const std::vector<std::string>& names) {
  for (std::size_t i = 0; i < names.size(); ++i) index_.emplace(trimmed(names[i]), i);
}

std::string Columns::text(const std::vector<std::string>& cells, const std::string& name) const {
  const auto found = index_.find(name);
  return found == index_.end() || found->second >= cells.size() ? std::string()
                                                                : trimmed(cells[found->second]);
}

}  // namespace facenav::interop
