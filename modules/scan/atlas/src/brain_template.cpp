#include "facenav/atlas/brain_template.h"

#include <cmath>
#include <fstream>
#include <sstream>

#include "facenav/core/error.h"
#include "facenav/volume/nifti.h"

namespace facenav::atlas {
namespace fs = std::filesystem;
namespace {

volume::Volume read(const fs::path& path) {
  if (!fs::exists(path))
    throw Error("the atlas is not installed", path.string(), "install Debian's mricron-data");
  return volume::readNifti(path).volume;
}

/// Reads lines like "1 Precentral_L 2001".
std::map<int, std::string> readNames(const fs::path& path) {
  std::ifstream stream(path);
  if (!stream)
    throw Error("the atlas' names are not installed", path.string(), "install Debian's mricron-data");
  std::map<int, std::string> names;
  for (std::string line; std::getline(stream, line);) {
    std::istringstream words(line);
    int label = 0;
    std::string name;
    if (words >> label >> name) names[label] = name;
  }
  return names;
}

std::map<int, std::string> brodmannNames() {
  std::map<int, std::string> names;
  for (int area = 1; area <= 52; ++area) names[area] = "BA " + std::to_string(area);
  return names;
}

}  // namespace

BrainTemplate readColin27(const fs::path& folder) {
  return {read(folder / "ch2bet.nii.gz"),
          {"AAL", read(folder / "aal.nii.gz"), readNames(folder / "aal.nii.txt")},
          {"Brodmann", read(folder / "brodmann.nii.gz"), brodmannNames()}};
}

Label labelAt(const LabelMap& map, const Point<Mni>& p, double search_mm) {
  const auto& grid = map.labels.grid;
  const Eigen::Vector3d at = grid.mri_from_voxel.inverse() * p.mm, spacing_mm = grid.spacing_mm();
  constexpr double kMostVoxels = 1e6;
  if (!at.allFinite() || at.cwiseAbs().maxCoeff() > kMostVoxels) return {};
  const Eigen::Array3i reach = (search_mm / spacing_mm.array()).ceil().cast<int>();
  const Eigen::Array3i centre = at.array().round().cast<int>();
  Label nearest;
  double nearest_mm = search_mm;
  for (int k = centre[2] - reach[2]; k <= centre[2] + reach[2]; ++k)
    for (int j = centre[1] - reach[1]; j <= centre[1] + reach[1]; ++j)
      for (int i = centre[0] - reach[0]; i <= centre[0] + reach[0]; ++i) {
        if (!grid.contains(i, j, k)) continue;
        const auto name = map.names.find(int(std::lround(map.labels.at(i, j, k))));
        if (name == map.names.end()) continue;
        // distance to the voxel's box: 0 for a point inside the voxel
        const Eigen::Array3d beyond = ((Eigen::Array3d(i, j, k) - at.array()).abs() - 0.5).max(0.0);
        const double distance_mm = (beyond * spacing_mm.array()).matrix().norm();
        if (distance_mm > nearest_mm || (distance_mm == nearest_mm && !nearest.name.empty())) continue;
        nearest = {name->second, distance_mm};
        nearest_mm = distance_mm;
      }
  return nearest;
}

}  // namespace facenav::atlas
