#pragma once
// evaluation.csv as written by `facenav evaluate`: one row of named cells per run.

#include <filesystem>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "facenav/core/whole_file.h"

namespace facenav::testing {

inline std::vector<std::string> csvCells(const std::string& line) {
  std::vector<std::string> cells{""};
  bool is_quoted = false;
  for (const char c : line) {
    if (c == '"')
      is_quoted = !is_quoted;
    else if (c == ',' && !is_quoted)
      cells.emplace_back();
    else
      cells.back() += c;
  }
  return cells;
}

class EvaluationTable {
 public:
  explicit EvaluationTable(const std::filesystem::path& csv) {
    std::istringstream lines(readWholeFile(csv));
    std::string line;
    std::getline(lines, line);
    const auto names = csvCells(line);
    while (std::getline(lines, line)) {
      const auto cells = csvCells(line);
      rows_.emplace_back();
      for (std::size_t i = 0; i < names.size() && i < cells.size(); ++i) rows_.back()[names[i]] = cells[i];
    }
  }

  /// Values of one figure over all runs of a scenario ("": of all), where it was measured.
  std::vector<double> figure(const std::string& scenario, const std::string& name) const {
    std::vector<double> values;
    for (const auto& row : rows_)
      if ((scenario.empty() || row.at("scenario") == scenario) && !row.at(name).empty())
        values.push_back(std::stod(row.at(name)));
    return values;
  }
  std::vector<std::string> failures() const {
    std::vector<std::string> found;
    for (const auto& row : rows_)
      if (!row.at("failure").empty()) found.push_back(row.at("scenario") + ": " + row.at("failure"));
    return found;
  }

 private:
  std::vector<std::map<std::string, std::string>> rows_;
};

}  // namespace facenav::testing
