#include "facenav/report/pulse_map.h"

#include "facenav/core/settings_in_force.h"

namespace facenav::report {

std::vector<std::optional<Point<Mri>>> placesOn(const surface::TriangleMesh& surface,
                                                const std::vector<casefile::ReviewedPulse>& pulses) {
  std::vector<std::optional<Point<Mri>>> places;
  places.reserve(pulses.size());
  for (const auto& reviewed : pulses) {
    const auto mri_T_coil = reviewed.pulse.mri_T_coil();
    places.push_back(mri_T_coil ? guidance::axisOnSurface(surface, *mri_T_coil) : std::nullopt);
  }
  return places;
}

std::optional<guidance::MepMap> mepMapOf(const surface::TriangleMesh& surface,
                                         const std::vector<casefile::ReviewedPulse>& pulses,
                                         const std::vector<std::optional<Point<Mri>>>& places) {
  std::vector<guidance::MepSite> sites;
  for (std::size_t i = 0; i < pulses.size(); ++i) {
    const auto& mep_uv = pulses[i].pulse.mep_uv;
    if (!pulses[i].is_excluded && places[i] && mep_uv) sites.push_back({*places[i], *mep_uv});
  }
  return guidance::mepMap(surface, sites, settingsOf<guidance::MepMapOptions>());
}

}  // namespace facenav::report
