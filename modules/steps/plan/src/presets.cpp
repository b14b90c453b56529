#include "facenav/plan/presets.h"

#include <algorithm>
#include <cctype>

#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "facenav/guidance/hand_knob.h"

namespace facenav::steps {
namespace {

constexpr char kEeg[] = "eeg:", kMirrored[] = "mirror image of the left one";

std::string lower(std::string text) {
  for (char& c : text) c = char(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

Preset inBrain(const std::string& name, const std::string& what, const Point<Mni>& p,
               const std::string& source) {
  return {name, formatted("%s, MNI %.0f %.0f %.0f", what.c_str(), p.mm.x(), p.mm.y(), p.mm.z()), source, p};
}

std::vector<Preset> makePresets() {
  std::vector<Preset> all{
      inBrain("m1-hand-left", "hand area of the left M1", guidance::handKnob(guidance::Side::left),
              "hand knob, Yousry 1997; the start of the search for the hotspot, not the hotspot"),
      inBrain("m1-hand-right", "hand area of the right M1", guidance::handKnob(guidance::Side::right),
              kMirrored),
      inBrain("dlpfc-fox", "left prefrontal cortex (DLPFC)", {-38, 44, 26},
              "most anticorrelated with the subgenual cingulate in groups, Fox 2012"),
      inBrain("dlpfc-fox-right", "right prefrontal cortex (DLPFC)", {38, 44, 26}, kMirrored),
      inBrain("dlpfc-group", "left prefrontal cortex (DLPFC)", {-42, 44, 30},
              "group target of later comparisons"),
      inBrain("dlpfc-group-right", "right prefrontal cortex (DLPFC)", {42, 44, 30}, kMirrored),
      {"beam-f3", "F3 by Beam's method, from three tape measures", "Beam 2009", std::nullopt},
      {"beam-f4", "F4 by Beam's method, from three tape measures", kMirrored, std::nullopt}};
  for (const std::string& site : guidance::eegSiteNames())
    all.push_back({kEeg + site, "site " + site + " of the 10-20 system", "Jasper 1958", std::nullopt});
  return all;
}

}  // namespace

const std::vector<Preset>& presets() {
  static const std::vector<Preset> kPresets = makePresets();
  return kPresets;
}

const Preset& presetNamed(const std::string& name) {
  static const std::vector<std::pair<std::string, std::string>> kOldNames{
      {"eeg:t3", "eeg:t7"}, {"eeg:t4", "eeg:t8"}, {"eeg:t5", "eeg:p7"}, {"eeg:t6", "eeg:p8"}};
  std::string wanted = lower(name), known;
  for (const auto& [old, present] : kOldNames)
    if (wanted == old) wanted = present;
  for (const Preset& preset : presets()) {
    if (lower(preset.name) == wanted) return preset;
    if (preset.name.rfind(kEeg, 0) != 0) known += preset.name + ", ";
  }
  throw Error("there is no preset '" + name + "'", {},
              "choose one of: " + known + "eeg:C3 and the other EEG sites");
}

const surface::ScalpPaths& HeadMeasures::paths() const {
  if (!paths_) paths_.emplace(scalp_->mesh);
  return *paths_;
}

const guidance::EegSites& HeadMeasures::eegSites() const {
  if (!sites_) sites_ = guidance::placeEegSitesWithErrors(paths(), landmarks_);
  return *sites_;
}

const guidance::BeamF3& HeadMeasures::beamF3(guidance::Side side) const {
  auto& beam = beam_[side == guidance::Side::left ? 0 : 1];
  if (!beam) beam = guidance::placeBeamF3(paths(), eegSites(), side);
  return *beam;
}

PresetPlace placeOf(const Preset& preset, const atlas::AtlasMap* atlas, const HeadMeasures& measures) {
  if (preset.mni) {
    if (!atlas)
      throw Error("the case has no atlas registration, which '" + preset.name + "' needs", {},
                  "prepare it again with --replace (its targets are kept), or type RAS coordinates");
    return {atlas->toMri(*preset.mni), std::nullopt, preset.words};
  }
  const auto& sites = measures.eegSites();
  if (preset.name == "beam-f3" || preset.name == "beam-f4") {
    const bool is_left = preset.name == "beam-f3";
    const auto& beam = measures.beamF3(is_left ? guidance::Side::left : guidance::Side::right);
    const double sd_mm = sites.find(is_left ? "F3" : "F4").sd_mm;  // from the same landmarks
    return {std::nullopt, beam.point,
            formatted("nasion-inion %.0f mm, tragus-tragus %.0f mm, circumference %.0f mm: x %.0f mm, y %.0f "
                      "mm, +- %.0f mm by the landmarks",
                      sites.nasion_inion_mm, sites.tragus_tragus_mm, sites.circumference_mm,
                      beam.lengths.x_mm, beam.lengths.y_mm, sd_mm)};
  }
  const auto& site = sites.find(preset.name.substr(sizeof(kEeg) - 1));
  std::string words = formatted("%s +- %.0f mm by the landmarks", site.name.c_str(), site.sd_mm);
  if (site.span_mm > 2) words += formatted("; the tape passes %.0f mm over the skin there", site.span_mm);
  return {std::nullopt, site.point, words};
}

}  // namespace facenav::steps
