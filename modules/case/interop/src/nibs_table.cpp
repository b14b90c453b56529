#include "nibs_table.h"

#include <algorithm>
#include <cmath>

#include "facenav/core/error.h"
#include "facenav/core/number_text.h"

namespace facenav::interop {

NibsTable::NibsTable(const FileSet& files, const std::string& name)
    : name_(lastOf(name)), columns_(std::vector<std::string>{}) {
  std::size_t width = 0;
  int number = 0;
  for (const auto& line : linesOf(files.read(name))) {
    ++number;
    if (trimmed(line).empty()) continue;
    auto cells = cellsOf(line, '\t');
    if (width == 0) {
      columns_ = Columns(cells);
      width = cells.size();
      continue;
    }
    if (cells.size() != width)
      refuseFile(files.path(name), formatted("line %d", number),
                 formatted("has %d cells, the header %d", int(cells.size()), int(width)),
                 "copy or export it again");
    rows_.push_back(std::move(cells));
    lines_.push_back(number);
  }
}

std::string NibsTable::text(std::size_t row, const std::string& column) const {
  const std::string cell = columns_.text(rows_[row], column);
  return cell == "n/a" || cell == "N/A" ? std::string() : cell;
}

std::optional<double> NibsTable::number(std::size_t row, const std::string& column) const {
  const std::string cell = text(row, column);
  return cell.empty() ? std::nullopt : std::optional<double>(numberOrNan(cell));
}

std::optional<Eigen::Vector3d> NibsTable::three(std::size_t row, const std::string& stem) const {
  Eigen::Vector3d v = Eigen::Vector3d::Constant(std::nan(""));
  bool is_given = false;
  for (int axis = 0; axis < 3; ++axis)
    if (const auto value = number(row, stem + "xyz"[axis])) {
      v[axis] = *value;
      is_given = true;
    }
  return is_given ? std::optional<Eigen::Vector3d>(v) : std::nullopt;
}

std::string NibsTable::where(std::size_t row) const {
  return formatted("%s, line %d", name_.c_str(), line(row));
}

NibsName::NibsName(const std::string& name) : folder(folderOf(name)) {
  for (const auto& part : cellsOf(lastOf(name), '_')) {
    if (contains(part, "."))
      suffix = part;
    else
      entities.push_back(part);
  }
}

std::string NibsName::entity(const std::string& key) const {
  for (const auto& entity : entities)
    if (startsWith(entity, key + "-")) return entity.substr(key.size() + 1);
  return {};
}

std::string NibsName::beside(const std::string& other_suffix) const {
  std::string name = folder;
  for (const auto& entity : entities) name += entity + "_";
  return name + other_suffix;
}

std::string NibsName::words() const {
  std::string words;
  for (const auto& entity : entities)
    if (!startsWith(entity, "sub-")) words += (words.empty() ? "" : "_") + entity;
  return words;
}

std::optional<JsonReader> nearestJson(const FileSet& files, const NibsName& table,
                                      const std::string& suffix) {
  const auto applies = [&](const NibsName& side) {
    return side.suffix == suffix &&
           std::all_of(side.entities.begin(), side.entities.end(), [&](const std::string& entity) {
             return std::count(table.entities.begin(), table.entities.end(), entity) > 0;
           });
  };
  for (std::string folder = table.folder;; folder = folderOf(folder.substr(0, folder.size() - 1))) {
    std::string best;
    std::size_t most = 0;
    for (const auto& name : files.names()) {
      if (folderOf(name) != folder || !endsWith(name, suffix)) continue;
      const NibsName side(name);
      if (!applies(side) || (!best.empty() && side.entities.size() <= most)) continue;
      best = name;
      most = side.entities.size();
    }
    if (!best.empty()) return JsonReader::readText(files.read(best), files.path(best));
    if (folder.empty()) return std::nullopt;
  }
}

std::string wordOf(const JsonReader& json, const std::string& key) {
  return json.has(key) && json.at(key).isText() ? json.at(key).text() : std::string();
}

std::optional<double> numberOf(const JsonReader& json, const std::string& key) {
  if (!json.has(key)) return std::nullopt;
  if (json.at(key).isText()) return valueIn(json.at(key).text());
  try {
    return json.at(key).number();
  } catch (const Error&) {
    return std::nullopt;
  }
}

std::vector<JsonReader> listOf(const JsonReader& json, const std::string& key) {
  if (!json.has(key) || json.at(key).isNull() || json.at(key).isText()) return {};
  try {
    return json.at(key).elements();
  } catch (const Error&) {
    return {json.at(key)};  // an object
  }
}

}  // namespace facenav::interop
