#include "skin_doubt.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "facenav/core/robust_statistics.h"
#include "facenav/surface/scalp_surface.h"
#include "facenav/volume/mask_morphology.h"
#include "facenav/volume/regrid.h"

namespace facenav::surface {
namespace {

constexpr double kInside_mm = 3, kOutside_mm = 5, kDoubtStep_mm = 0.5, kFromSkin_mm = 2;
// The edge's half level is between the surroundings and the tissue this far below the skin: deeper fat is
// brighter, and would move the half level inwards although the skin is clear.
constexpr double kJustBelow_mm = 1.5;
constexpr int kDoubtSmoothings = 2;
constexpr double kFarAir_mm = 15;   // haze does not reach so far from the head
constexpr double kFarEvery_mm = 2;  // distance of the places where it is measured
constexpr std::size_t kLeastFarPlaces = 1000;

// Standard errors of the skin in mm, fitted; larger values are the safe direction.
constexpr double kPerShare_mm = 4.5;  // per signal outside the skin, as a share of the tissue's
constexpr double kFreeShare = 0.12;   // this much signal outside has no effect
constexpr double kPerSpread = 0.8;    // per distance of the edge's half from the steepest place
constexpr double kMost_mm = 3;

/// Tissue below one place, the level around it and the half level between them.
struct Place {
  float tissue = 0, around = 0;
  double half_mm = 0;  // > 0 outside the vertex
};

Place placeAt(const volume::Volume& scan, const Eigen::Vector3d& p_mm, const Eigen::Vector3d& normal) {
  std::vector<float> values, outside;
  for (double t = -kInside_mm; t <= kOutside_mm; t += kDoubtStep_mm) {
    values.push_back(volume::sampleLinear(scan, scan.grid.toVoxel(Point<Mri>(p_mm + t * normal))));
    if (t >= kFromSkin_mm) outside.push_back(values.back());
  }
  Place place;
  const std::size_t skin = std::size_t(kInside_mm / kDoubtStep_mm);
  place.tissue = *std::max_element(values.begin(), values.begin() + std::ptrdiff_t(skin) + 1);
  place.around = upperMedian(std::move(outside));
  const std::ptrdiff_t just_below = std::ptrdiff_t((kInside_mm - kJustBelow_mm) / kDoubtStep_mm);
  const float level =
      *std::max_element(values.begin() + just_below, values.begin() + std::ptrdiff_t(skin) + 1);
  const float half = 0.5f * (level + place.around);
  std::size_t at = skin + 4;  // seen from outside, 2 mm beyond the skin
  while (at > 0 && values[at] < half) --at;
  place.half_mm = double(at) * kDoubtStep_mm - kInside_mm;
  if (at + 1 < values.size() && values[at] > values[at + 1])
    place.half_mm +=
        kDoubtStep_mm * std::clamp((values[at] - half) / (values[at] - values[at + 1]), 0.f, 1.f);
  return place;
}

/// Level of the air far from the head. nullopt if too few places were measured: a value of exactly 0, or one
/// that most places share, was set by a program.
std::optional<float> farAir(const volume::Volume& scan, const volume::Mask& head) {
  // A coarse grid is enough: at 0.5 mm a map of distances would be as large as the scan.
  const volume::Mask coarse = volume::resample(head, volume::isotropicGrid(head.grid, kFarEvery_mm));
  const std::vector<float> away_mm = volume::distanceTo(coarse);
  std::vector<float> far;
  std::size_t at = 0;
  for (int k = 0; k < coarse.grid.size[2]; ++k)
    for (int j = 0; j < coarse.grid.size[1]; ++j)
      for (int i = 0; i < coarse.grid.size[0]; ++i, ++at) {
        if (!(away_mm[at] > float(kFarAir_mm))) continue;
        const auto value = volume::valueAt(scan, coarse.grid.toMri({double(i), double(j), double(k)}));
        if (value && *value != 0) far.push_back(*value);
      }
  if (far.size() <= kLeastFarPlaces) return {};
  const float air = selectRank(far, far.size() / 2);
  const auto same = std::size_t(std::count(far.begin(), far.end(), air));
  return 2 * same > far.size() ? std::nullopt : std::optional<float>(air);
}

std::vector<float> averaged(std::vector<float> values, const MeshNeighbours& neighbours) {
  for (int pass = 0; pass < kDoubtSmoothings; ++pass) {
    const std::vector<float> before = values;
    for (std::size_t v = 0; v < values.size(); ++v) {
      float sum = before[v];
      for (int e = neighbours.first[v]; e < neighbours.first[v + 1]; ++e) sum += before[neighbours.all[e]];
      values[v] = sum / float(1 + neighbours.first[v + 1] - neighbours.first[v]);
    }
  }
  return values;
}

}  // namespace

std::vector<float> skinDoubt_mm(const TriangleMesh& mesh, const MeshNeighbours& neighbours,
                                const volume::Volume& scan, const volume::Mask& head) {
  std::vector<Place> places;
  std::vector<float> around, halves;
  for (std::size_t v = 0; v < mesh.vertices_mm.size(); ++v) {
    places.push_back(placeAt(scan, mesh.vertices_mm[v], mesh.normals[v]));
    around.push_back(places.back().around), halves.push_back(float(places.back().half_mm));
  }
  if (places.empty()) return {};
  const float near_air = valueAtRank(around, around.size() / 5), usual_mm = upperMedian(halves);
  const float air = std::min(near_air, farAir(scan, head).value_or(near_air));
  std::vector<float> share(places.size()), spread_mm(places.size());
  for (std::size_t v = 0; v < places.size(); ++v) {
    const Place& place = places[v];
    share[v] = std::clamp((place.around - air) / std::max(1e-6f, place.tissue - air), 0.f, 1.f);
    spread_mm[v] = std::abs(float(place.half_mm) - usual_mm);
  }
  share = averaged(std::move(share), neighbours), spread_mm = averaged(std::move(spread_mm), neighbours);
  std::vector<float> doubt_mm(places.size());
  for (std::size_t v = 0; v < places.size(); ++v) {
    const double by_share = kPerShare_mm * std::max(0.0, double(share[v]) - kFreeShare);
    doubt_mm[v] =
        float(std::min(kMost_mm, std::hypot(kClearSkin_mm, std::hypot(by_share, kPerSpread * spread_mm[v]))));
  }
  return doubt_mm;
}

}  // namespace facenav::surface
