#include "facenav/treat/hotspot.h"

#include <algorithm>
#include <cmath>

#include "facenav/core/error.h"
#include "facenav/core/settings_in_force.h"
#include "facenav/geometry/normal_equations.h"
#include "facenav/guidance/handle.h"

namespace facenav::steps {
namespace {

constexpr int kMostCells = 15;
constexpr double kLeastSpacing_mm = 1, kMostSpacing_mm = 40;

struct Answered {
  const casefile::ReviewedPulse* reviewed;
  double value;  // uV, or 0 and 1
};

std::vector<Answered> answeredWithMep(const casefile::SessionPulses& session) {
  std::vector<Answered> answered;
  for (const auto& reviewed : session.pulses)
    if (!reviewed.is_excluded && reviewed.pulse.mep_uv)
      answered.push_back({&reviewed, *reviewed.pulse.mep_uv});
  return answered;
}

std::vector<Answered> answeredWithTwitch(const casefile::SessionPulses& session,
                                         const std::map<int, bool>& twitches) {
  std::vector<Answered> answered;
  for (const auto& reviewed : session.pulses) {
    const auto twitch = twitches.find(reviewed.pulse.number);
    if (!reviewed.is_excluded && twitch != twitches.end())
      answered.push_back({&reviewed, twitch->second ? 1.0 : 0.0});
  }
  return answered;
}

/// The coil over the cortex point that lies beside the seed's in the coil's plane. The handle keeps its
/// direction. Throws like guidance::planTarget.
guidance::Target besideOnCortex(const guidance::Target& seed, const surface::ScalpSurface& scalp, double x_mm,
                                double y_mm) {
  const Eigen::Matrix3d axes = seed.mri_T_target.rotation();
  const Eigen::Vector3d step = axes * Eigen::Vector3d(x_mm, y_mm, 0.0);
  const auto there = guidance::planTarget(seed.name, scalp, Point<Mri>(seed.cortex_point.mm + step), 0.0,
                                          guidance::hairGap_mm(seed));
  const Eigen::Quaterniond transport = rotationBetween(axes.col(2), there.mri_T_target.rotation().col(2));
  guidance::Target beside = seed;
  beside.cortex_point = there.cortex_point;
  beside.scalp_point = there.scalp_point;
  beside.lift_mm = 0;
  beside.mri_T_target = RigidTransform<Mri, frames::Target>(transport * Eigen::Quaterniond(axes),
                                                            there.mri_T_target.translation_mm());
  return beside;
}

}  // namespace

std::vector<guidance::Target> huntingSites(const guidance::Target& seed, const surface::ScalpSurface& scalp,
                                           const HuntingGrid& grid) {
  if (grid.rows < 1 || grid.columns < 1 || grid.rows > kMostCells || grid.columns > kMostCells ||
      !(grid.spacing_mm >= kLeastSpacing_mm && grid.spacing_mm <= kMostSpacing_mm))
    throw Error("no such hunting grid", {}, "give 1 to 15 rows and columns, and 1 to 40 mm between them");
  struct Site {
    double distance;
    guidance::Target target;
  };
  std::vector<Site> sites;
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column) {
      const double y_mm = grid.spacing_mm * (0.5 * (grid.rows - 1) - row);
      const double x_mm = grid.spacing_mm * (column - 0.5 * (grid.columns - 1));
      try {
        auto target = x_mm == 0 && y_mm == 0 ? seed : besideOnCortex(seed, scalp, x_mm, y_mm);
        target.name = seed.name + " " + std::to_string(row + 1) + "/" + std::to_string(column + 1);
        sites.push_back({std::hypot(x_mm, y_mm), std::move(target)});
      } catch (const Error&) {  // no scalp there: outside the scan, or over the ear
      }
    }
  std::stable_sort(sites.begin(), sites.end(),
                   [](const Site& a, const Site& b) { return a.distance < b.distance - 1e-9; });
  std::vector<guidance::Target> targets;
  for (auto& site : sites) targets.push_back(std::move(site.target));
  return targets;
}

std::optional<Hotspot> hotspotOf(const surface::TriangleMesh& surface, const casefile::SessionPulses& session,
                                 const std::map<int, bool>& twitches) {
  Hotspot hotspot;
  auto answered = answeredWithMep(session);
  hotspot.is_share = answered.empty();
  if (hotspot.is_share) answered = answeredWithTwitch(session, twitches);
  std::vector<guidance::MepSite> sites;
  double largest = 0;
  for (const auto& [reviewed, value] : answered) {
    const auto pose = reviewed->pulse.mri_T_coil();
    const auto place = pose ? guidance::axisOnSurface(surface, *pose) : std::nullopt;
    if (!place) {
      ++hotspot.without_place;
      continue;
    }
    sites.push_back({*place, value});
    if (value > largest) largest = value, hotspot.peak_pulse = reviewed->pulse.number;
  }
  hotspot.pulses = int(sites.size());
  auto options = settingsOf<guidance::MepMapOptions>();
  if (hotspot.is_share) options.mep_threshold_uv = 0.5;  // half of the pulses
  hotspot.sigma_mm = options.mep_sigma_mm;
  auto map = guidance::mepMap(surface, sites, options);
  if (!map) return std::nullopt;
  hotspot.map = std::move(*map);
  return hotspot;
}

}  // namespace facenav::steps
