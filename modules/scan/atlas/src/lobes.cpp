#include "facenav/atlas/lobes.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace facenav::atlas {
namespace {

constexpr int kCoarser = 2;          // label voxels per voxel of the map
constexpr double kBeyond_mm = 20.0;  // labels are extended this far

/// Prefixes of AAL's names and their regions; the first match counts.
constexpr std::array<std::pair<const char*, const char*>, 36> kLobes{{
    {"Temporal_Pole", "temporal pole"},
    {"Temporal_Inf", "underside of the temporal lobe"},
    {"Fusiform", "underside of the temporal lobe"},
    {"ParaHippocampal", "underside of the temporal lobe"},
    {"Temporal", "temporal lobe"},
    {"Heschl", "temporal lobe"},
    {"Hippocampus", "underside of the temporal lobe"},
    {"Amygdala", "underside of the temporal lobe"},
    {"Rectus", "underside of the frontal lobe"},
    {"Olfactory", "underside of the frontal lobe"},
    {"Frontal_Sup_Orb", "underside of the frontal lobe"},
    {"Frontal_Mid_Orb", "underside of the frontal lobe"},
    {"Frontal_Inf_Orb", "underside of the frontal lobe"},
    {"Frontal_Med_Orb", "underside of the frontal lobe"},
    {"Precentral", "motor strip"},
    {"Postcentral", "sensory strip"},
    {"Rolandic", "sensory strip"},
    {"Paracentral", "motor strip"},
    {"Supp_Motor", "frontal lobe"},
    {"Frontal", "frontal lobe"},
    {"Cingulum_Ant", "frontal lobe"},
    {"Parietal", "parietal lobe"},
    {"SupraMarginal", "parietal lobe"},
    {"Angular", "parietal lobe"},
    {"Precuneus", "parietal lobe"},
    {"Cingulum", "parietal lobe"},
    {"Calcarine", "occipital lobe"},
    {"Cuneus", "occipital lobe"},
    {"Lingual", "occipital lobe"},
    {"Occipital", "occipital lobe"},
    {"Cerebelum", "cerebellum"},
    {"Vermis", "cerebellum"},
    {"Insula", "insula"},
    {"Thalamus", "brainstem and base"},
    {"Pallidum", "brainstem and base"},
    {"Putamen", "brainstem and base"},
}};

std::string regionOf(const std::string& aal) {
  for (const auto& [start, lobe] : kLobes) {
    if (aal.rfind(start, 0) != 0) continue;
    const std::string end = aal.size() > 2 ? aal.substr(aal.size() - 2) : "";
    return (end == "_L" ? "left " : end == "_R" ? "right " : "") + std::string(lobe);
  }
  return "";
}

/// Each unlabelled voxel takes the region of a labelled neighbour, one ring of voxels after the other.
void growOutwards(std::vector<std::uint8_t>& region, const std::array<int, 3>& n, int rings) {
  const std::array<std::ptrdiff_t, 3> stride{1, n[0], std::ptrdiff_t(n[0]) * n[1]};
  std::vector<std::size_t> front;
  for (std::size_t v = 0; v < region.size(); ++v)
    if (region[v]) front.push_back(v);
  for (int ring = 0; ring < rings; ++ring) {
    std::vector<std::size_t> next;
    for (const std::size_t v : front) {
      const std::array<int, 3> at{int(v % n[0]), int(v / n[0] % n[1]), int(v / stride[2])};
      for (int a = 0; a < 3; ++a)
        for (int step : {-1, 1}) {
          if (at[a] + step < 0 || at[a] + step >= n[a]) continue;
          const std::size_t neighbour = std::size_t(std::ptrdiff_t(v) + step * stride[a]);
          if (region[neighbour]) continue;
          region[neighbour] = region[v];
          next.push_back(neighbour);
        }
    }
    front.swap(next);
  }
}

}  // namespace

LobeMap::LobeMap(const LabelMap& aal) : names_{""} {
  std::map<int, std::uint8_t> index;
  for (const auto& [label, name] : aal.names) {
    const std::string region = regionOf(name);
    auto known = std::find(names_.begin() + 1, names_.end(), region);
    if (region.empty()) continue;
    if (known == names_.end()) known = names_.insert(names_.end(), region);
    index[label] = std::uint8_t(known - names_.begin());
  }
  const auto& labels = aal.labels;
  grid_ = labels.grid;
  for (int& size : grid_.size) size = (size + kCoarser - 1) / kCoarser;
  grid_.mri_from_voxel.linear() *= kCoarser;
  region_.assign(grid_.count(), 0);
  std::size_t v = 0;
  for (int k = 0; k < grid_.size[2]; ++k)
    for (int j = 0; j < grid_.size[1]; ++j)
      for (int i = 0; i < grid_.size[0]; ++i, ++v) {
        const auto found = index.find(int(std::lround(labels.at(kCoarser * i, kCoarser * j, kCoarser * k))));
        if (found != index.end()) region_[v] = found->second;
      }
  growOutwards(region_, grid_.size, int(kBeyond_mm / grid_.spacing_mm().mean()));
}

const std::string& LobeMap::at(const Point<Mni>& p) const {
  const Eigen::Array3i at = (grid_.mri_from_voxel.inverse() * p.mm).array().round().cast<int>();
  return grid_.contains(at[0], at[1], at[2]) ? names_[region_[grid_.index(at[0], at[1], at[2])]] : names_[0];
}

}  // namespace facenav::atlas
