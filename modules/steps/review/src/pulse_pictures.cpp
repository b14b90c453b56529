#include "facenav/review/pulse_pictures.h"

#include <algorithm>

#include "facenav/core/number_text.h"
#include "facenav/core/settings_in_force.h"
#include "facenav/report/pulse_map.h"
#include "facenav/scene/display.h"

namespace facenav::steps {
namespace {

constexpr int kWidth_px = 720, kHeight_px = 560;

std::vector<guidance::Target> targetsOf(const std::vector<casefile::ReviewedPulse>& pulses) {
  std::vector<guidance::Target> targets;
  for (const auto& reviewed : pulses) {
    const auto& target = reviewed.pulse.target;
    const auto is_it = [&](const guidance::Target& other) { return other.name == target->name; };
    if (target && std::none_of(targets.begin(), targets.end(), is_it)) targets.push_back(*target);
  }
  return targets;
}

std::string colourWords(report::PulseColumn column, const scene::ColourRange& range) {
  const auto& words = report::wordsOf(column);
  return formatted("Coloured by %s: dark %.*f %s, bright %.*f %s.", words.name, words.decimals, range.low,
                   words.unit, words.decimals, range.high, words.unit);
}

std::string mapWords(const guidance::MepMap& map) {
  const auto& p = map.peak.mm;
  const auto& c = map.centre_of_gravity.mm;
  return formatted(
      "Map of the MEPs on the brain's surface (Gaussian, sigma %g mm): dark 0, bright %.0f uV. Peak %.0f uV "
      "at "
      "%.1f %.1f %.1f, centre of gravity %.1f %.1f %.1f (MRI, RAS mm), area with %g uV or more %.0f mm2, %d "
      "of "
      "%d pulses with a response.",
      settingsOf<guidance::MepMapOptions>().mep_sigma_mm, map.peak_uv, map.peak_uv, p.x(), p.y(), p.z(),
      c.x(), c.y(), c.z(), settingsOf<guidance::MepMapOptions>().mep_threshold_uv, map.area_mm2,
      map.responses, map.sites);
}

}  // namespace

std::optional<scene::ColourRange> rangeOf(const std::vector<casefile::ReviewedPulse>& pulses,
                                          report::PulseColumn column) {
  std::optional<scene::ColourRange> range;
  for (const auto& reviewed : pulses) {
    const auto value = report::valueOf(reviewed.pulse, column);
    if (!value || reviewed.is_excluded) continue;
    if (!range) range = scene::ColourRange{*value, *value};
    range->low = std::min(range->low, *value);
    range->high = std::max(range->high, *value);
  }
  return range;
}

std::vector<scene::PulseMark> marksOf(const std::vector<casefile::ReviewedPulse>& pulses,
                                      const std::vector<std::optional<Point<Mri>>>& places,
                                      report::PulseColumn column, std::optional<int> chosen) {
  const auto range = rangeOf(pulses, column);
  std::vector<scene::PulseMark> marks;
  for (std::size_t i = 0; i < pulses.size(); ++i) {
    const auto mri_T_coil = pulses[i].pulse.mri_T_coil();
    if (!mri_T_coil) continue;
    const auto value = report::valueOf(pulses[i].pulse, column);
    scene::PulseMark mark;
    mark.mri_T_coil = *mri_T_coil;
    if (i < places.size()) mark.on_cortex = places[i];
    mark.colour = value && range ? scene::sequentialColour(range->shareOf(*value)) : scene::palette::kLost;
    mark.is_excluded = pulses[i].is_excluded;
    mark.is_chosen = chosen == pulses[i].pulse.number;
    marks.push_back(mark);
  }
  return marks;
}

std::vector<report::ReportPicture> pulsePictures(const casefile::CaseStore& store,
                                                 const casefile::KeptSession& session,
                                                 std::vector<std::optional<Point<Mri>>> places) {
  const auto& pulses = session.pulses.pulses;
  const auto range = rangeOf(pulses, report::PulseColumn::distance);
  if (!range || !scene::canDrawScenes()) return {};
  const auto brain = store.brain();
  if (brain && places.size() != pulses.size()) places = report::placesOn(brain->mesh, pulses);
  scene::NavigationScene scene;
  scene.setScalp(store.scalp().mesh);
  if (brain) scene.setBrain(*brain);
  const auto targets = targetsOf(pulses);
  scene.setTargets(targets, targets.empty() ? "" : targets.front().name);
  scene::PulseLayer layer(scene);
  layer.set(marksOf(pulses, places, report::PulseColumn::distance));
  std::vector<report::ReportPicture> pictures;
  scene.setView(scene::ViewPreset::target);
  pictures.push_back({"From the side of the target. " + colourWords(report::PulseColumn::distance, *range),
                      scene.render(kWidth_px, kHeight_px)});
  scene.setView(scene::ViewPreset::top);
  pictures.push_back(
      {"From above, patient's front upwards; same colours.", scene.render(kWidth_px, kHeight_px)});
  if (!brain) return pictures;
  if (const auto map = report::mepMapOf(brain->mesh, pulses, places)) {
    layer.set({});
    layer.setHeat(brain->mesh, map->mep_uv, {0, map->peak_uv});
    scene.setView(scene::ViewPreset::target);
    pictures.push_back({mapWords(*map), scene.render(kWidth_px, kHeight_px)});
  }
  return pictures;
}

}  // namespace facenav::steps
