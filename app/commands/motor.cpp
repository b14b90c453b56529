// facenav hotspot CASE [SESSION] and facenav note CASE [SESSION]: results from the muscle's responses, and
// manual entries about a session.

#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "commands/commands.h"
#include "facenav/casefile/kept_session.h"
#include "facenav/casefile/twitches.h"
#include "facenav/core/error.h"
#include "facenav/efield/coil_file.h"
#include "facenav/report/session_notes.h"
#include "facenav/treat/hotspot.h"
#include "facenav/treat/mep_by_field.h"
#include "facenav/treat/pulse_fields.h"
#include "wrong_usage.h"

namespace facenav::app {
namespace {

using Json = nlohmann::ordered_json;

surface::TriangleMesh cortexOf(const casefile::CaseStore& store) {
  if (auto brain = store.brain()) return std::move(brain->mesh);
  throw Error("the case has no brain model", store.folder().string(),
              "prepare it from a scan of the whole head");
}

Json pointOf(const Point<Mri>& p) { return {p.mm.x(), p.mm.y(), p.mm.z()}; }

Json toJson(const steps::Hotspot& h) {
  return {{"unit", h.is_share ? "share" : "uV"},
          {"pulses", h.pulses},
          {"without_place", h.without_place},
          {"responses", h.map.responses},
          {"centre_of_gravity_mm", pointOf(h.map.centre_of_gravity)},
          {"peak_mm", pointOf(h.map.peak)},
          {"peak", h.map.peak_uv},
          {"largest", h.map.largest_uv},
          {"largest_pulse", h.peak_pulse},
          {"area_mm2", h.map.area_mm2},
          {"sigma_mm", h.sigma_mm}};
}

std::string words(const Point<Mri>& p) {
  char text[96];
  std::snprintf(text, sizeof text, "%.1f %.1f %.1f", p.mm.x(), p.mm.y(), p.mm.z());
  return text;
}

void print(const steps::Hotspot& h) {
  std::printf("%d pulses with an answer, %d responses%s\n", h.pulses, h.map.responses,
              h.is_share ? " (twitches, no MEPs)" : "");
  if (h.without_place > 0) std::printf("%d more have no place on the cortex: left out\n", h.without_place);
  std::printf("peak of the map: %s mm, %.*f %s\n", words(h.map.peak).c_str(), h.is_share ? 2 : 0,
              h.map.peak_uv, h.is_share ? "of the pulses" : "uV");
  std::printf("centre of gravity: %s mm\n", words(h.map.centre_of_gravity).c_str());
  std::printf("area: %.0f mm2 on the cortex (Gaussian of %.1f mm sigma)\n", h.map.area_mm2, h.sigma_mm);
  std::printf("largest answer: pulse %d\n", h.peak_pulse);
}

Json curveJson(const steps::MepByField& map) {
  const auto& curve = map.curve;
  Json json{
      {"words", steps::curveWords(map)}, {"aicc_gain", curve.aicc_gain}, {"r2_line", curve.r2_line},
      {"r2_sigmoid", curve.r2_sigmoid},  {"slope", curve.slope},         {"intercept", curve.intercept}};
  json["sigmoid"] = Json();
  if (curve.verdict == stimulation::CurveVerdict::sigmoid)
    json["sigmoid"] = {{"low", curve.sigmoid.low},
                       {"height", curve.sigmoid.height},
                       {"midpoint_v_per_m_at_1_a_per_us", curve.sigmoid.midpoint},
                       {"width_v_per_m_at_1_a_per_us", curve.sigmoid.width}};
  return json;
}

Json toJson(const steps::MepByField& map, const std::string& coil) {
  const auto& found = map.regression;
  Json json{{"by", "field"},
            {"is_explained", found.is_explained},
            {"pulses", map.pulses},
            {"left_out", map.left_out},
            {"with_intensity", map.by_rate},
            {"coil", steps::fieldCoilName(coil)},
            {"tier", int(map.tier)},
            {"response", toString(found.response)},
            {"r2", found.r2},
            {"r2_linear", found.r2_linear.maxCoeff()},
            {"r2_log", found.r2_log.maxCoeff()},
            {"chance", found.chance}};
  json["spot_mm"] = found.is_explained ? pointOf(map.spot) : Json();
  json["region_mm"] = found.is_explained ? Json(map.region_mm) : Json();
  json["region_places"] = found.is_explained ? Json(map.region_places) : Json();
  json["curve"] = found.is_explained ? curveJson(map) : Json();
  return json;
}

struct HotspotRequest {
  std::filesystem::path case_folder;
  std::string session, by = "axis", coil = steps::kUsualFieldCoil;
  bool is_json = false;
};

void showByField(const HotspotRequest& request, const casefile::CaseStore& store,
                 const std::filesystem::path& folder) {
  const steps::PoseFields fields(std::make_shared<const steps::ReadHead>(store),
                                 efield::fieldCoil(request.coil).dipoles);
  const auto map = steps::mepByField(fields, casefile::readSessionPulses(folder));
  if (request.is_json) return void(std::printf("%s\n", toJson(map, request.coil).dump(1).c_str()));
  for (const auto& line : steps::inWords(map, request.coil)) std::printf("%s\n", line.c_str());
}

struct Notes {
  std::filesystem::path case_folder;
  std::string session, adverse, by, muscle, stimulator;
  std::optional<double> pain_before, pain_after;
};

using Entry = std::pair<const char*, std::string>;

std::vector<Entry> entriesOf(const Notes& notes) {
  namespace events = report::session_events;
  std::vector<Entry> entries;  // all are checked before the first is written
  if (notes.pain_before) entries.emplace_back(events::kPainBefore, report::painWords(*notes.pain_before));
  if (notes.pain_after) entries.emplace_back(events::kPainAfter, report::painWords(*notes.pain_after));
  const Entry texts[] = {{events::kAdverse, notes.adverse},
                         {events::kOperator, notes.by},
                         {events::kMuscle, notes.muscle},
                         {events::kStimulator, notes.stimulator}};
  for (const auto& [event, text] : texts)
    if (!text.empty()) entries.emplace_back(event, report::noteWords(text, event));
  return entries;
}

}  // namespace

void addHotspot(CLI::App& app, Context& context) {
  auto* verb = app.add_subcommand(
      "hotspot",
      "where the muscle answers most: peak, centre of gravity and area on the cortex, of a session's pulses");
  auto request = std::make_shared<HotspotRequest>();
  verb->add_option("CASE", request->case_folder, "case folder")->required();
  verb->add_option("SESSION", request->session, "its name, or how it begins; default: the newest");
  verb->add_option(
          "--by", request->by,
          "axis: where the coil's axis meets the brain; field: which place's field explains the MEPs")
      ->check(CLI::IsMember({"axis", "field"}))
      ->capture_default_str();
  verb->add_option("--coil", request->coil,
                   "with --by field: the coil's field, figure8-70, round, or a .ccd, .tcd, .nii.gz file")
      ->capture_default_str();
  verb->add_flag("--json", request->is_json, "as JSON");
  verb->callback([&context, request] {
    (void)context;
    const auto store = casefile::CaseStore::open(request->case_folder);
    const auto folder = casefile::findSession(store.folder(), request->session);
    if (request->by == "field") return showByField(*request, store, folder);
    const auto hotspot = steps::hotspotOf(cortexOf(store), casefile::readSessionPulses(folder),
                                          casefile::readTwitches(folder));
    if (!hotspot)
      throw Error("no pulse with a pose has a response of the muscle", folder.string(),
                  "enter MEPs or twitches first");
    request->is_json ? void(std::printf("%s\n", toJson(*hotspot).dump(1).c_str())) : print(*hotspot);
  });
}

void addNote(CLI::App& app, Context& context) {
  auto* verb = app.add_subcommand("note", "enters pain, adverse events and who treated into a session");
  auto notes = std::make_shared<Notes>();
  verb->add_option("CASE", notes->case_folder, "case folder")->required();
  verb->add_option("SESSION", notes->session, "its name, or how it begins; default: the newest");
  verb->add_option("--pain-before", notes->pain_before, "0 (none) to 10 (the worst imaginable)")
      ->check(CLI::Range(0.0, 10.0));
  verb->add_option("--pain-after", notes->pain_after, "likewise, after the session")
      ->check(CLI::Range(0.0, 10.0));
  verb->add_option("--adverse-event", notes->adverse, "what happened, in words");
  verb->add_option("--operator", notes->by, "who treated: name or initials (not the patient's)");
  verb->add_option("--muscle", notes->muscle, "muscle and side");
  verb->add_option("--stimulator", notes->stimulator, "make and model");
  verb->callback([&context, notes] {
    const auto entries = entriesOf(*notes);
    if (entries.empty())
      throw WrongUsage("nothing to note", "give --pain-before, --adverse-event or another one");
    const auto store = casefile::CaseStore::open(notes->case_folder);
    const auto folder = casefile::findSession(store.folder(), notes->session);
    for (const auto& [event, detail] : entries) casefile::addNote(folder, event, detail);
    if (!context.is_quiet)
      std::printf("%zu noted in session %s\n", entries.size(), folder.filename().c_str());
  });
}

}  // namespace facenav::app
