// facenav coil list|show|add|remove: the library of coils.

#include <cstdio>
#include <nlohmann/json.hpp>

#include "commands/coil_option.h"
#include "commands/commands.h"
#include "facenav/core/error.h"
#include "facenav/guidance/coil_plate.h"

namespace facenav::app {
namespace {

using Json = nlohmann::ordered_json;

struct CoilRequest {
  CoilChoice coil;
  coil_library::CoilChanges changes;
  std::vector<double> focus_mm;
  bool is_json = false, replaces = false;

  std::filesystem::path library() const { return coil_library::coilLibrary(coil.library); }
};

Json calibrationJson(const coil_tracking::CalibrationRecord& record) {
  return {{"method", record.method},       {"utc", record.utc},
          {"rms_mm", record.rms_mm},       {"sigma_mm", record.sigma_mm},
          {"sigma_deg", record.sigma_deg}, {"frames", record.frames}};
}

Json toJson(const coil_library::LibraryCoil& coil) {
  Json json{{"name", coil.name}, {"file", coil.file.string()}};
  if (!coil.problem.empty()) {
    json["problem"] = coil.problem;
    return json;
  }
  const auto& card = coil.card;
  json["make"] = card.make;
  json["model"] = card.model;
  json["serial"] = card.serial;
  json["focus_mm"] = {card.focus_mm.x(), card.focus_mm.y(), card.focus_mm.z()};
  json["markers"] = Json::array();
  for (const auto& marker : coil.model.markers)
    json["markers"].push_back({{"print", coil_tracking::markerWords(marker)}, {"size_mm", marker.size_mm}});
  json["contact_outline_mm"] = card.has_outline ? Json::array() : Json();
  if (card.has_outline)
    for (const auto& corner : guidance::readPlate(coil.file).outline_mm)
      json["contact_outline_mm"].push_back({corner.x(), corner.y()});
  json["calibration"] = card.calibration ? calibrationJson(*card.calibration) : Json();
  const auto reminder = coil_library::calibrationReminder(card);
  json["reminder"] = reminder ? Json(*reminder) : Json();
  return json;
}

void print(const Json& json) {
  std::printf("%s\n", json.dump(1, ' ', false, Json::error_handler_t::replace).c_str());
}

void noteReminder(const coil_library::LibraryCoil& coil) {
  if (!coil.problem.empty()) return;
  if (const auto reminder = coil_library::calibrationReminder(coil.card))
    std::printf("  note: %s\n", reminder->c_str());
}

void list(const CoilRequest& request) {
  const auto coils = coil_library::coilsIn(request.library());
  if (request.is_json) {
    Json all = Json::array();
    for (const auto& coil : coils) all.push_back(toJson(coil));
    return print(all);
  }
  if (coils.empty())
    return void(
        std::printf("no coil in %s: add one with 'facenav coil add coil.json'\n", request.library().c_str()));
  for (const auto& coil : coils) {
    std::printf("%s\n", inWords(coil).c_str());
    noteReminder(coil);
  }
}

void show(const CoilRequest& request) {
  const auto coil = coil_library::findCoil(request.library(), request.coil.words);
  if (request.is_json) return print(toJson(coil));
  std::printf("%s\n", inWords(coil).c_str());
  for (const auto& marker : coil.model.markers)
    std::printf("  marker %s, black square %.2f mm\n", coil_tracking::markerWords(marker).c_str(),
                marker.size_mm);
  std::printf("  contact outline: %s\n", coil.card.has_outline ? "its own" : "a usual figure-of-eight's");
  const auto& focus = coil.card.focus_mm;
  std::printf("  focus at %.1f %.1f %.1f mm of the contact face's centre%s\n", focus.x(), focus.y(),
              focus.z(), coil.card.isFocusCentred() ? "" : "; guidance aims with the centre");
  noteReminder(coil);
  std::printf("  file %s\n", coil.file.c_str());
}

void add(const CoilRequest& request, bool is_quiet) {
  coil_library::CoilChanges changes = request.changes;
  if (!request.focus_mm.empty())
    changes.focus_mm = Eigen::Vector3d(request.focus_mm[0], request.focus_mm[1], request.focus_mm[2]);
  const auto coil = coil_library::addCoil(request.library(), request.coil.words, changes, request.replaces);
  if (request.is_json) return print(toJson(coil));
  if (is_quiet) return;
  std::printf("added %s\n", inWords(coil).c_str());
  noteReminder(coil);
}

CLI::App* step(CLI::App& verb, const char* name, const char* help, CoilRequest& request) {
  auto* made = verb.add_subcommand(name, help);
  addCoilLibraryOption(*made, request.coil.library);
  made->add_flag("--json", request.is_json, "JSON");
  return made;
}

}  // namespace

void addCoil(CLI::App& app, Context& context) {
  auto* verb = app.add_subcommand("coil", "the library of coils: list, show, add, remove");
  verb->require_subcommand(1);
  auto request = std::make_shared<CoilRequest>();
  step(*verb, "list", "the coils of the library, with markers and calibration", *request)
      ->callback([request] { list(*request); });
  auto* shown = step(*verb, "show", "all that is known of a coil", *request);
  shown->add_option("NAME", request->coil.words, "name, or its beginning")->required();
  shown->callback([request] { show(*request); });
  auto* added =
      step(*verb, "add", "copies a coil.json with its mesh and patterns into the library", *request);
  added->add_option("FILE", request->coil.words, "coil.json")->required();
  added->add_option("--name", request->changes.name, "its name in the library; default: as in the file");
  added->add_option("--make", request->changes.make, "who made it");
  added->add_option("--model", request->changes.model, "model");
  added->add_option("--serial", request->changes.serial, "serial number");
  added
      ->add_option("--focus", request->focus_mm,
                   "x y z (Coil, mm) where its field is strongest; default: the contact face's centre")
      ->expected(3);
  added->add_flag("--replace", request->replaces, "replaces the coil of that name");
  added->callback([request, &context] { add(*request, context.is_quiet); });
  auto* removed = step(*verb, "remove", "removes a coil from the library", *request);
  removed->add_option("NAME", request->coil.words, "name, or its beginning")->required();
  removed->callback([request] { coil_library::removeCoil(request->library(), request->coil.words); });
  for (auto* each : verb->get_subcommands({})) each->add_flag("-q,--quiet", "no notes");
}

}  // namespace facenav::app
