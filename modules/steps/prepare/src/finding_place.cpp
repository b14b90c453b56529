#include "facenav/prepare/finding_place.h"

#include <utility>

namespace facenav::steps {
namespace {

struct Region {
  const char* words;  // as in the finding; the left side's
  double mni_mm[3];   // near the middle of the region's surface
};
// The first that is found counts, so longer names come first.
constexpr Region kRegions[] = {{"temporal pole", {-42, 14, -30}},
                               {"underside of the temporal lobe", {-42, -30, -22}},
                               {"underside of the frontal lobe", {-24, 36, -16}},
                               {"motor strip", {-40, -14, 54}},
                               {"sensory strip", {-44, -28, 52}},
                               {"temporal lobe", {-58, -24, -6}},
                               {"frontal lobe", {-32, 40, 28}},
                               {"parietal lobe", {-38, -56, 46}},
                               {"occipital lobe", {-26, -90, 6}},
                               {"insula", {-38, 4, 2}},
                               {"cerebellum", {-24, -66, -38}},
                               {"brainstem and base", {0, -28, -38}}};

bool says(const std::string& finding, const char* words) { return finding.find(words) != std::string::npos; }

/// The vertex that lies furthest along `direction`.
std::optional<Point<Mri>> extremeOf(const surface::ScalpSurface& scalp, const Eigen::Vector3d& direction) {
  const Eigen::Vector3d* furthest = nullptr;
  for (const auto& vertex : scalp.mesh.vertices_mm)
    if (!furthest || direction.dot(vertex) > direction.dot(*furthest)) furthest = &vertex;
  return furthest ? std::optional(Point<Mri>(*furthest)) : std::nullopt;
}

std::optional<Point<Mri>> placeInBrain(const std::string& finding, const atlas::AtlasMap& atlas) {
  for (const Region& region : kRegions) {
    if (!says(finding, region.words)) continue;
    Eigen::Vector3d mni_mm(region.mni_mm[0], region.mni_mm[1], region.mni_mm[2]);
    if (says(finding, "right")) mni_mm.x() = -mni_mm.x();
    return atlas.toMri(Point<Mni>(mni_mm));
  }
  return std::nullopt;
}

}  // namespace

std::optional<Point<Mri>> placeOfFinding(const std::string& finding, const surface::ScalpSurface& scalp,
                                         const atlas::AtlasMap* atlas) {
  if (says(finding, "look at the"))
    if (const auto place = atlas ? placeInBrain(finding, *atlas) : std::nullopt) return place;
  if (says(finding, "top of the head") || says(finding, "upper head"))
    return extremeOf(scalp, Eigen::Vector3d::UnitZ());
  if (says(finding, "left side of the head")) return extremeOf(scalp, -Eigen::Vector3d::UnitX());
  if (says(finding, "an ear is") || says(finding, "side of the head is"))
    return extremeOf(scalp, Eigen::Vector3d::UnitX());
  for (const char* words : {"face", "nose", "brow", "lip", "chin", "forehead"})
    if (says(finding, words)) return extremeOf(scalp, Eigen::Vector3d::UnitY());
  return std::nullopt;
}

}  // namespace facenav::steps
