#include "commands/plan_print.h"

#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "facenav/geometry/rotation.h"
#include "facenav/guidance/dose_json.h"
#include "facenav/guidance/handle.h"
#include "json_output.h"

namespace facenav::app {
namespace {

using Json = nlohmann::ordered_json;

double tenthDegrees(double rad) { return tenth(rad * kDegPerRad); }

Json beamJson(const guidance::BeamF3& beam) {
  return {
      {"x_mm", tenth(beam.lengths.x_mm)}, {"y_mm", tenth(beam.lengths.y_mm)}, {"mm", tenths(beam.point.mm)}};
}

}  // namespace

void printPresets(bool is_json) {
  Json list = Json::array();
  for (const auto& preset : steps::presets()) {
    if (!is_json) {
      std::printf("%-14s %s (%s)\n", preset.name.c_str(), preset.words.c_str(), preset.source.c_str());
      continue;
    }
    list.push_back({{"name", preset.name}, {"words", preset.words}, {"source", preset.source}});
    if (preset.mni) list.back()["mni_mm"] = tenths(preset.mni->mm);
  }
  if (is_json) printJson({{"presets", list}});
}

void printLandmarks(const surface::ScalpLandmarks& landmarks, bool is_json) {
  Json list = Json::array();
  for (const auto which : surface::kLandmarks) {
    const auto& landmark = landmarks[which];
    const std::string name = toString(which);
    if (!landmark) {
      if (!is_json)
        std::printf("%-13s not known: set it with --set-landmark %s=X,Y,Z\n", name.c_str(), name.c_str());
      continue;
    }
    const Eigen::Vector3d& p = landmark->point.mm;
    if (!is_json) {
      std::printf("%-13s %7.1f %7.1f %7.1f  +- %.0f mm  by %s%s%s\n", name.c_str(), p.x(), p.y(), p.z(),
                  landmark->sd_mm, toString(landmark->source).c_str(),
                  landmark->by.empty() ? "" : (" of " + landmark->by).c_str(),
                  landmark->is_cut ? "; on the scan's edge: check it" : "");
      continue;
    }
    list.push_back({{"name", name},
                    {"mm", tenths(p)},
                    {"sd_mm", tenth(landmark->sd_mm)},
                    {"source", toString(landmark->source)},
                    {"on_scan_edge", landmark->is_cut}});
  }
  if (is_json) printJson({{"landmarks", list}});
}

void printMeasures(const steps::HeadMeasures& measures, bool is_json) {
  const auto& eeg = measures.eegSites();
  const auto &left = measures.beamF3(guidance::Side::left), &right = measures.beamF3(guidance::Side::right);
  if (is_json) {
    Json sites = Json::array();
    for (const auto& site : eeg.sites)
      sites.push_back({{"name", site.name},
                       {"mm", tenths(site.point.mm)},
                       {"sd_mm", tenth(site.sd_mm)},
                       {"tape_over_skin_mm", tenth(site.span_mm)}});
    return printJson({{"nasion_inion_mm", tenth(eeg.nasion_inion_mm)},
                      {"tragus_tragus_mm", tenth(eeg.tragus_tragus_mm)},
                      {"circumference_mm", tenth(eeg.circumference_mm)},
                      {"beam_f3", beamJson(left)},
                      {"beam_f4", beamJson(right)},
                      {"sites", sites}});
  }
  std::printf("nasion-inion %.0f mm, tragus-tragus %.0f mm, circumference over Fpz and Oz %.0f mm\n",
              eeg.nasion_inion_mm, eeg.tragus_tragus_mm, eeg.circumference_mm);
  for (const auto& site : eeg.sites)
    std::printf("%-8s %7.1f %7.1f %7.1f  +- %.0f mm%s\n", site.name.c_str(), site.point.mm.x(),
                site.point.mm.y(), site.point.mm.z(), site.sd_mm,
                site.span_mm > 2 ? "  (the tape passes over a hollow)" : "");
  for (const auto& [name, beam] : {std::pair("Beam F3", &left), std::pair("Beam F4", &right)})
    std::printf("%s  %7.1f %7.1f %7.1f  x %.0f mm, y %.0f mm\n", name, beam->point.mm.x(), beam->point.mm.y(),
                beam->point.mm.z(), beam->lengths.x_mm, beam->lengths.y_mm);
}

void printPlan(const guidance::TreatmentPlan& plan, const steps::PlannedHead& head, bool is_json) {
  Json list = Json::array();
  for (const auto& target : plan.targets) {
    const auto contact = guidance::contactOf(target, *head.scalp, head.plate);
    const double handle_deg = tenthDegrees(guidance::handleAngle(target, *head.scalp).angle_rad);
    const double skin_mm = surface::skinDoubtUnder_mm(*head.scalp, target.scalp_point);
    const Eigen::Vector3d& p = target.cortex_point.mm;
    if (!is_json) {
      std::printf("%-24s cortex %6.1f %6.1f %6.1f  handle %+4.0f deg  gap %.1f mm%s%s\n", target.name.c_str(),
                  p.x(), p.y(), p.z(), handle_deg, std::max(0.0, guidance::hairGap_mm(target)),
                  target.is_locked ? "  locked" : "", contact.isTangent() ? "" : "  not tangent");
      if (skin_mm > 0.5)
        std::printf(
            "%-24s the skin beneath the coil is unsure by %.1f mm (pads or haze in the scan), and so is "
            "the gap\n",
            "", skin_mm);
      if (!contact.isTangent())
        std::printf("%-24s coil %.1f mm over the skin, tilted %.0f deg, %zu contacts, %.1f mm through it\n",
                    "", contact.lift_mm, tenthDegrees(contact.tilt_rad), contact.touching.size(),
                    contact.through_mm);
      continue;
    }
    list.push_back({{"name", target.name},
                    {"cortex_point_mm", tenths(p)},
                    {"handle_deg", handle_deg},
                    {"gap_mm", tenth(guidance::hairGap_mm(target))},
                    {"skin_sd_mm", tenth(skin_mm)},
                    {"lift_mm", tenth(contact.lift_mm)},
                    {"tilt_deg", tenthDegrees(contact.tilt_rad)},
                    {"through_mm", tenth(contact.through_mm)},
                    {"locked", target.is_locked},
                    {"note", target.note}});
  }
  if (is_json) printJson({{"targets", list}});
}

void printDifference(const std::string& first, const std::string& second, const guidance::TargetDifference& d,
                     double along_scalp_mm, bool is_json) {
  if (is_json)
    return printJson({{"from", first},
                      {"to", second},
                      {"centres_mm", tenth(d.centres_mm)},
                      {"along_scalp_mm", tenth(along_scalp_mm)},
                      {"cortex_mm", tenth(d.cortex_mm)},
                      {"lateral_mm", tenth(d.lateral_mm)},
                      {"depth_mm", tenth(d.depth_mm)},
                      {"tilt_deg", tenthDegrees(d.tilt_rad)},
                      {"twist_deg", tenthDegrees(d.twist_rad)}});
  std::printf("'%s' from '%s': centre %.1f mm away (%.1f mm along the scalp), cortex %.1f mm\n",
              second.c_str(), first.c_str(), d.centres_mm, along_scalp_mm, d.cortex_mm);
  std::printf("lateral %.1f mm, depth %.1f mm, tilt %.1f deg, twist %.1f deg\n", d.lateral_mm, d.depth_mm,
              tenthDegrees(d.tilt_rad), tenthDegrees(d.twist_rad));
}

void printProtocol(const std::optional<casefile::Protocol>& protocol, bool is_json) {
  if (!protocol) return is_json ? printJson({{"protocol", nullptr}}) : void(std::printf("no protocol\n"));
  if (is_json) {
    Json json{{"name", protocol->name}, {"version", protocol->version}};
    for (const auto& [key, value] : guidance::doseNumbers(protocol->dose)) json[key] = value;
    return printJson({{"protocol", json}});
  }
  const auto& dose = protocol->dose;
  std::printf("protocol '%s', version %d: %d pulses in %d trains at %g Hz", protocol->name.c_str(),
              protocol->version, dose.pulses, dose.trains, dose.frequency_hz);
  if (const auto duration_s = dose.duration_s()) std::printf(", %.1f min", *duration_s / 60);
  if (dose.output_pct) std::printf(", %g %% of output", *dose.output_pct);
  if (dose.threshold_pct) std::printf(", %g %% of the motor threshold", *dose.threshold_pct);
  std::printf("\n");
}

}  // namespace facenav::app
