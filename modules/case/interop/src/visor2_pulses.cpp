#include <algorithm>

#include "facenav/core/number_text.h"
#include "readers.h"
#include "text.h"

// visor2's list of pulses (.csv): places in the frame of nasion and ears. The file holds no landmarks, and
// how the axes of its coil lie is not documented, so only places are taken.

namespace facenav::interop {
namespace {

constexpr const char* kFirst = "visor2 software version";
constexpr const char* kNeeded[] = {"Stimulus ID", "Coordinate system", "Coil position x (mm)",
                                   "Coil position y (mm)", "Coil position z (mm)"};

/// A line's cells. Tables of some countries are separated by semicolons.
std::vector<std::string> cellsOfLine(const std::string& line, bool has_semicolons) {
  return has_semicolons ? cellsOf(line, ';') : csvCellsOf(line);
}

std::string known(const Columns& columns, const std::vector<std::string>& cells, const std::string& name) {
  const std::string cell = columns.text(cells, name);
  return cell == "NULL" || cell == "(null)" ? std::string() : cell;
}

Item itemOf(const Columns& columns, const std::vector<std::string>& cells) {
  const auto text = [&](const std::string& name) { return known(columns, cells, name); };
  Item item;
  item.kind = Kind::pulse;
  item.name = "pulse " + text("Stimulus ID");
  item.session = text("Session");
  item.intensity_pct = valueIn(text("Stimulation intensity (%)"));
  const std::string time = text("TMS stimulus time (clock time)");
  item.time = time;
  setTime(time, item);
  const bool has_place = std::any_of(std::begin(kNeeded) + 2, std::end(kNeeded),
                                     [&](const char* name) { return !text(name).empty(); });
  item.reason = has_place ? kPlaceOnly : "the file has no pose for it";
  if (has_place)
    item.place_mm = Eigen::Vector3d(numberOrNan(text(kNeeded[2])), numberOrNan(text(kNeeded[3])),
                                    numberOrNan(text(kNeeded[4])));
  for (const char* name : {"TMS coil", "Coil rotation x", "Coil rotation y", "Coil rotation z",
                           "Coil rotation w", "rTMS count", "rTMS frequency (hz)", "Errors"})
    if (!text(name).empty()) item.values[name] = text(name);
  return item;
}

/// Times of day become seconds since the first pulse of the session: the list has no date.
void setOnsets(OtherFile& file) {
  std::map<std::string, double> first_s;
  for (auto& item : file.items) {
    if (item.clock_s) continue;
    item.onset_s = clockOf("1970-01-01", item.time);
    if (!item.onset_s) continue;
    const auto found = first_s.emplace(item.session, *item.onset_s).first;
    found->second = std::min(found->second, *item.onset_s);
  }
  for (auto& item : file.items)
    if (item.onset_s) *item.onset_s -= first_s[item.session];
}

/// Sets the space by the words of the rows that have a place.
void setSpace(const std::string& words, OtherFile& file) {
  file.space_words = words;
  file.is_of_head_frame = words == "nasion-ear";
  if (contains(words, "MNI"))
    file.space = Space::mni;
  else if (contains(words, "Talairach"))
    file.space = Space::talairach;
  else if (!file.is_of_head_frame)
    file.space = Space::unknown;
}

}  // namespace

bool isVisor2Pulses(const std::string& content) {
  const auto lines = linesOf(content.substr(0, 4000));
  return !lines.empty() && contains(lines[0], kFirst) && contains(lines[0], "Stimulus ID");
}

OtherFile readVisor2Pulses(const Source& source) {
  const auto lines = linesOf(source.content);
  const auto count = [&](char c) { return std::count(lines[0].begin(), lines[0].end(), c); };
  const bool has_semicolons = count(';') > count(',');
  const auto names = cellsOfLine(lines[0], has_semicolons);
  const Columns columns(names);
  for (const char* name : kNeeded)
    if (!columns.has(name))
      refuseFile(source.path, "line 1", "its column '" + std::string(name) + "' is missing");
  OtherFile file;
  file.words = "visor2 list of pulses";
  for (std::size_t i = 1; i < lines.size(); ++i) {
    if (trimmed(lines[i]).empty()) continue;
    const auto cells = cellsOfLine(lines[i], has_semicolons);
    const std::string where = formatted("line %d", int(i) + 1);
    if (cells.size() != names.size())
      refuseFile(source.path, where,
                 formatted("has %d cells, the header %d", int(cells.size()), int(names.size())),
                 "copy or export it again");
    Item item = itemOf(columns, cells);
    item.where = where;
    const std::string system = known(columns, cells, "Coordinate system");
    if (item.place_mm && file.space_words.empty()) setSpace(system, file);
    if (item.place_mm && system != file.space_words)
      refuseFile(source.path, where, "is in '" + system + "', other pulses in '" + file.space_words + "'",
                 "export one coordinate system");
    file.items.push_back(std::move(item));
  }
  setOnsets(file);
  return file;
}

}  // namespace facenav::interop
