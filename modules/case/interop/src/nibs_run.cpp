#include "nibs_run.h"

#include "facenav/core/number_text.h"
#include "text.h"

namespace facenav::interop {
namespace {

std::optional<double> mmPer(const std::string& unit) {
  if (unit == "mm" || unit == "millimetre" || unit == "millimeter") return 1.0;
  if (unit == "cm") return 10.0;
  if (unit == "m") return 1000.0;
  return std::nullopt;
}

double scaleOf(const NibsRun& run) {
  const std::string of_system =
      run.coordsystem ? wordOf(*run.coordsystem, "NIBSCoordinateUnits") : std::string();
  std::string of_column;
  const auto described = nearestJson(run.files, run.name, "markers.json");
  if (described && described->has("element_centre_x"))
    of_column = wordOf(described->at("element_centre_x"), "Units");
  const auto a = mmPer(of_system), b = mmPer(of_column);
  const auto refuse = [&](const std::string& what) {
    refuseFile(run.files.path(run.markers), "", what,
               "state NIBSCoordinateUnits as mm, cm or m in its coordsystem.json");
  };
  if (a && b && *a != *b)
    refuse("its unit is '" + of_system + "' by coordsystem.json and '" + of_column + "' by markers.json");
  if (!a && !b) refuse("the unit of its coordinates is not stated");
  return a ? *a : *b;
}

/// Part of a list for one element; the only part where the cell is no list.
std::string partOf(const std::string& cell, std::size_t element) {
  const auto parts = partsOf(cell);
  if (parts.size() == 1) return parts[0];
  return element < parts.size() ? trimmed(parts[element]) : std::string();
}

}  // namespace

NibsRun::NibsRun(const FileSet& all, const std::string& markers_name)
    : files(all), name(markers_name), markers(markers_name) {
  coordsystem = nearestJson(all, name, "coordsystem.json");
  nibs = nearestJson(all, name, "nibs.json");
  mm_per_unit = scaleOf(*this);
}

std::vector<std::string> partsOf(const std::string& cell) {
  return cell.empty() ? std::vector<std::string>{""} : cellsOf(cell, '|');
}

NibsStrengths::NibsStrengths(const NibsRun& run) {
  const std::string name = run.name.beside("nibs.tsv");
  if (!run.files.has(name)) return;
  table_.emplace(run.files, name);
  for (std::size_t row = 0; row < table_->rows(); ++row) rows_[table_->text(row, "nibs_event_id")] = row;
  if (!run.nibs) return;
  if (run.nibs->has("stimulus_intensity")) unit_ = wordOf(run.nibs->at("stimulus_intensity"), "Units");
  for (const auto& reference : listOf(*run.nibs, "IntensitySet"))
    if (const auto value = numberOf(reference, "Value"); value && contains(wordOf(reference, "Units"), "%"))
      references_[wordOf(reference, "IntensityID")] = *value;
}

void NibsStrengths::describe(const std::string& kind, std::size_t element, Item& item) const {
  const auto found = rows_.find(kind);
  if (found == rows_.end()) return;
  const std::size_t row = found->second;
  const auto cell = [&](const char* column) { return partOf(table_->text(row, column), element); };
  if (unit_.empty() || contains(unit_, "%")) item.intensity_pct = valueIn(cell("stimulus_intensity"));
  if (!item.intensity_pct) item.intensity_pct = valueIn(cell("pattern1_intensity"));
  const auto reference = references_.find(cell("intensity_reference"));
  const auto factor = valueIn(cell("intensity_scaling"));
  if (!item.intensity_pct && factor && reference != references_.end())
    item.intensity_pct = *factor * reference->second;
  if (item.intensity_pct && (*item.intensity_pct < 0 || *item.intensity_pct > 100))
    item.intensity_pct.reset();
  for (const char* column : {"nibs_element_id", "stimulus_shape", "current_direction"})
    if (!cell(column).empty()) item.values[column] = cell(column);
}

std::optional<double> startOf(const NibsRun& run) {
  for (std::string folder = run.name.folder;; folder = folderOf(folder.substr(0, folder.size() - 1))) {
    for (const auto& name : run.files.names()) {
      if (folderOf(name) != folder || !endsWith(name, "_scans.tsv")) continue;
      const NibsTable scans(run.files, name);
      for (std::size_t row = 0; row < scans.rows(); ++row) {
        const std::string file = folder + scans.text(row, "filename"), time = scans.text(row, "acq_time");
        const bool is_of_run =
            NibsName(file).folder == run.name.folder && NibsName(file).entities == run.name.entities;
        if (is_of_run && time.size() >= 19 && time.substr(0, 4) >= "1925")
          return clockOf(time.substr(0, 10), time.substr(11, 12));
      }
    }
    if (folder.empty()) return std::nullopt;
  }
}

}  // namespace facenav::interop
