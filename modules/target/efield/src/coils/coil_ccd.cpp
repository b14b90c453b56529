// .ccd: line 1 "# ... version 1.0;key=value;..", line 2 the count, line 3 a comment, then a row a dipole: x y
// z in m, moment in A m^2 for 1 A.

#include <sstream>

#include "coil_readers.h"
#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "facenav/core/whole_file.h"

namespace facenav::efield {
namespace {

constexpr double kMmPerMetre = 1000;

/// Numbers of a row, between blanks or tabs. Throws Error that names the line.
std::vector<double> rowOf(const std::string& line, const std::filesystem::path& path, int number) {
  std::vector<double> row;
  std::istringstream words(line);
  for (std::string word; words >> word;) {
    const auto value = numberIn(word);
    if (!value)
      throw Error("'" + word.substr(0, 40) + "' is no number",
                  path.string() + ", line " + std::to_string(number), "copy or export the coil's file again");
    row.push_back(*value);
  }
  return row;
}

/// Text with '\n' after each line, whatever system wrote it, and without a byte order mark.
std::string plainLines(std::string text) {
  if (text.compare(0, 3, "\xef\xbb\xbf") == 0) text.erase(0, 3);
  std::string lines;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool is_pair = text[i] == '\r' && i + 1 < text.size() && text[i + 1] == '\n';
    if (!is_pair) lines += text[i] == '\r' ? '\n' : text[i];
  }
  return lines;
}

}  // namespace

std::string pairValue(const std::string& pairs, const std::string& key) {
  std::istringstream stream(pairs);
  for (std::string pair; std::getline(stream, pair, ';');) {
    const auto begin = pair.find_first_not_of(" \t#");
    const auto equals = pair.find('=');
    if (begin == std::string::npos || equals == std::string::npos ||
        pair.substr(begin, equals - begin) != key)
      continue;
    const auto end = pair.find_last_not_of(" \t\r");
    const std::string value = pair.substr(equals + 1, end - equals);
    return value == "none" ? "" : value;
  }
  return {};
}

CoilSource readCcd(const std::filesystem::path& path) {
  std::istringstream stream(plainLines(readWholeFile(path)));
  CoilSource source;
  std::vector<double> values;
  double announced = -1;
  int number = 0;
  for (std::string line; std::getline(stream, line);) {
    ++number;
    if (number == 1) {
      source.dipoles.name = pairValue(line, "coilname");
      source.dipoles.largest_didt_A_per_us = numberIn(pairValue(line, "dIdtmax")).value_or(0);
    }
    const auto first = line.find_first_not_of(" \t");
    if (first == std::string::npos || line[first] == '#') continue;
    const auto row = rowOf(line, path, number);
    if (row.size() == 1 && announced < 0 && values.empty()) {
      announced = row[0];
      continue;
    }
    if (row.size() != 6)
      throw Error("a dipole needs 6 numbers, this row has " + std::to_string(row.size()),
                  path.string() + ", line " + std::to_string(number), "copy or export the coil's file again");
    values.insert(values.end(), row.begin(), row.end());
  }
  const auto count = Eigen::Index(values.size() / 6);
  if (count == 0) throw Error("holds no dipole", path.string(), "choose the coil's .ccd file");
  if (announced >= 0 && announced != double(count))
    throw Error("announces " + fixed(announced, 0) + " dipoles and holds " + std::to_string(count),
                path.string(), "the file is not whole: copy it again");
  const Eigen::Map<const Eigen::MatrixXd> rows(values.data(), 6, count);
  source.dipoles.positions_mm = kMmPerMetre * rows.topRows<3>();
  source.dipoles.moments_Am2 = rows.bottomRows<3>();
  return source;
}

}  // namespace facenav::efield
