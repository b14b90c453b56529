#include "facenav/evaluation/head_labels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "facenav/core/error.h"
#include "facenav/volume/nifti.h"
#include "facenav/volume/regrid.h"

namespace facenav::evaluation {
namespace {

namespace fs = std::filesystem;

constexpr int kOutsideSkull = 500;  // labels above are classes of tissue outside the skull
// Background, outer fluid, vessels L and R, fifth ventricle, chiasm, extra labels beside them L and R.
constexpr std::array<int, 10> kNotBrain{0, 24, 30, 62, 72, 85, 136, 137, 163, 164};
constexpr std::size_t kNumbers = 5;  // at the end of a line

std::vector<std::string> cellsOf(const std::string& line) {
  std::vector<std::string> cells;
  std::stringstream stream(line);
  for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
  return cells;
}

[[noreturn]] void notStatistics(const fs::path& csv) {
  throw Error("these are no label statistics", csv.string(), "a line is: label, name, class, four numbers");
}

std::pair<int, LabelStatistics> rowOf(const std::string& line, const fs::path& csv) {
  const auto cells = cellsOf(line);
  if (cells.size() < kNumbers + 2) notStatistics(csv);
  const auto number = [&](std::size_t from_end) { return std::stod(cells[cells.size() - from_end]); };
  try {
    return {std::stoi(cells[0]), {int(number(5)), number(4), number(3), number(2), number(1)}};
  } catch (const std::logic_error&) {  // from stoi and stod
    notStatistics(csv);
  }
}

}  // namespace

std::map<int, LabelStatistics> readLabelStatistics(const fs::path& csv) {
  std::ifstream stream(csv);
  if (!stream) throw Error("the label statistics cannot be read", csv.string(), "give the labels' folder");
  std::map<int, LabelStatistics> rows;
  std::string line;
  std::getline(stream, line);  // names of the columns
  while (std::getline(stream, line))
    if (!line.empty()) rows.insert(rowOf(line, csv));
  if (rows.empty()) notStatistics(csv);
  return rows;
}

LabelledHead readLabelledHead(const fs::path& nifti) {
  const volume::Volume volume = volume::toRasOrder(volume::readNifti(nifti).volume);
  LabelledHead head{nifti.stem().stem().string(), volume.grid, {}};
  head.labels.reserve(volume.voxels.size());
  for (const float value : volume.voxels) {
    if (!(value >= 0 && value < 65535 && value == std::floor(value)))
      throw Error("this is no map of labels: it holds " + std::to_string(value), nifti.string(),
                  "whole numbers from 0 on are labels");
    head.labels.push_back(std::uint16_t(value));
  }
  return head;
}

fs::path sharedHeadLabels() {
  const char* shared = std::getenv("FACENAV_SHARED_DATA");
  return fs::path(shared && *shared ? shared : "../shared/data") / "head_labels";
}

std::vector<fs::path> labelledHeads(const fs::path& folder) {
  std::vector<fs::path> paths;
  std::error_code absent;
  for (const auto& entry : fs::directory_iterator(folder, absent)) {
    const std::string name = entry.path().filename().string();
    if (name.size() > 7 && name.substr(name.size() - 7) == ".nii.gz") paths.push_back(entry.path());
  }
  if (paths.empty())
    throw Error("there are no labelled heads here", folder.string(),
                "set FACENAV_SHARED_DATA or give --labels DIR");
  std::sort(paths.begin(), paths.end());
  return paths;
}

bool isBrainTissue(int label) {
  return label < kOutsideSkull && std::find(kNotBrain.begin(), kNotBrain.end(), label) == kNotBrain.end();
}

}  // namespace facenav::evaluation
