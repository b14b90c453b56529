#include "support/case_outline.h"

#include <fstream>
#include <set>

#include "facenav/casefile/kept_session.h"
#include "facenav/core/whole_file.h"
#include "support/case_files.h"
#include "support/session_outline.h"

namespace facenav::app {
namespace fs = std::filesystem;
namespace {

using Json = nlohmann::ordered_json;

constexpr std::uintmax_t kLargestText = 8 << 20;  // bytes; larger JSON is not read for names

/// Keys whose values a person typed, or that tell who somebody is.
const std::set<std::string> kPersonal{"label",  "by",     "name",   "case_id",
                                      "serial", "target", "muscle", "operator"};
const std::set<std::string> kPersonalEvents{"operator", "target", "coil", "muscle", "stimulator", "override"};

/// Files whose names are those of landmarks and of topics.
const std::set<std::string> kWithoutNames{"landmarks.json", "navigation_check.json"};

void addSecretsIn(const Json& json, Scrubber& scrubber) {
  if (json.is_array())
    for (const Json& element : json) addSecretsIn(element, scrubber);
  if (!json.is_object()) return;
  for (const auto& [key, value] : json.items()) {
    if (value.is_string() && kPersonal.count(key)) scrubber.addSecret(value.get<std::string>());
    addSecretsIn(value, scrubber);
  }
  const auto event = json.find("event"), detail = json.find("detail");
  if (event == json.end() || detail == json.end() || !event->is_string() || !detail->is_string()) return;
  if (kPersonalEvents.count(event->get<std::string>())) scrubber.addSecret(detail->get<std::string>());
}

/// A step of case.json: numbers stay; a text that may be a path becomes "[words]".
Json stepOf(const Json& step) {
  Json out;
  for (const char* key : {"step", "software_version"})
    if (step.contains(key) && step[key].is_string()) out[key] = step[key];
  if (step.contains("settings") && step["settings"].is_object())
    for (const auto& [key, value] : step["settings"].items())
      if (value.is_number()) out["settings"][key] = value;
  if (step.contains("options") && step["options"].is_object())
    for (const auto& [key, value] : step["options"].items()) {
      const std::string text = value.is_string() ? value.get<std::string>() : value.dump();
      out["options"][key] = text.find_first_not_of("0123456789.-+e") == std::string::npos ? text : "[words]";
    }
  return out;
}

Json headOf(const fs::path& file) {
  const Json json = Json::parse(readWholeFile(file));
  Json out{{"schema_version", json.value("schema_version", Json())},
           {"has_label", json.contains("label")},
           {"findings", json.contains("findings") ? json["findings"].size() : 0}};
  if (json.contains("mri")) out["mri"] = json["mri"];
  if (json.contains("brain_quality")) out["brain_quality"] = json["brain_quality"];
  if (json.contains("provenance"))
    for (const Json& step : json["provenance"]) out["provenance"].push_back(stepOf(step));
  return out;
}

/// Verdicts of the import check, without the words of its findings.
Json verdictsOf(const fs::path& file) {
  const Json json = Json::parse(readWholeFile(file));
  Json out{{"verdict", json.value("verdict", Json())}};
  for (const Json& finding : json.value("findings", Json::array()))
    out["findings"].push_back(
        {{"topic", finding.value("topic", Json())}, {"verdict", finding.value("verdict", Json())}});
  return out;
}

/// Figures of the alignment: errors and counts, no pose.
Json figuresOf(const fs::path& file, const Scrubber& scrubber) {
  const Json json = Json::parse(readWholeFile(file));
  Json out;
  for (const char* key :
       {"rms_mm", "max_mm", "inlier_fraction", "points", "face_scale", "face_scale_sigma", "from", "matcher"})
    if (json.contains(key)) out[key] = json[key];
  for (const Json& caution : json.value("cautions", Json::array()))
    if (caution.is_string()) out["cautions"].push_back(scrubber.scrubbed(caution.get<std::string>()));
  return out;
}

/// Adds a part of the outline; a fault of it becomes its content.
template <class Make>
void addPart(Json& outline, const char* name, const fs::path& file, Make make) {
  if (!fs::exists(file)) return;
  try {
    outline[name] = make(file);
  } catch (const std::exception&) {
    outline[name] = "damaged: it cannot be read";
  }
}

}  // namespace

void addSecretsBelow(const fs::path& folder, Scrubber& scrubber) {
  for (const fs::path& part : fs::absolute(folder).lexically_normal()) scrubber.addSecret(part.string());
  std::error_code fault;
  for (fs::recursive_directory_iterator at(folder, fault), end; !fault && at != end; at.increment(fault)) {
    const auto extension = at->path().extension();
    if ((extension != ".json" && extension != ".jsonl") || !at->is_regular_file(fault)) continue;
    if (at->file_size(fault) > kLargestText || kWithoutNames.count(at->path().filename().string())) continue;
    std::ifstream stream(at->path());
    if (extension == ".json") {
      addSecretsIn(Json::parse(stream, nullptr, false), scrubber);
      continue;
    }
    for (std::string line; std::getline(stream, line);)
      addSecretsIn(Json::parse(line, nullptr, false), scrubber);
  }
}

Json caseOutline(const fs::path& case_folder, const Scrubber& scrubber) {
  Json outline;
  addPart(outline, "case.json", case_folder / "case.json", headOf);
  addPart(outline, "navigation_check.json", case_folder / "navigation_check.json", verdictsOf);
  addPart(outline, "alignment.json", case_folder / "alignment.json",
          [&](const fs::path& file) { return figuresOf(file, scrubber); });
  outline["files"] = filesOfCase(case_folder);
  outline["sessions"] = Json::array();
  for (const auto& session : casefile::sessionFolders(case_folder))
    outline["sessions"].push_back(sessionOutline(session, scrubber));
  return outline;
}

}  // namespace facenav::app
