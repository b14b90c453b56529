#include "support/support_bundle.h"

#include <pwd.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <sstream>

#include "facenav/capture/rig_store.h"
#include "facenav/core/error.h"
#include "facenav/core/settings_in_force.h"
#include "facenav/core/whole_file.h"
#include "support/case_outline.h"
#include "support/machine_facts.h"

namespace facenav::app {
namespace fs = std::filesystem;
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kReadme =
    "FaceNav's support bundle. program.json: versions, settings; machine.json: this computer; rigs.json: "
    "kept camera pairs;\n"
    "case.json: outline of a case; log.txt: lines of a log. It holds no images, no poses and no dates. "
    "Names, paths, hosts,\n"
    "addresses and passwords were taken out. Look through it before you send it.\n";

void addSecretsOfComputer(Scrubber& scrubber) {
  std::array<char, 256> host{};
  if (::gethostname(host.data(), host.size() - 1) == 0) scrubber.addSecret(host.data());
  for (const char* name : {"USER", "LOGNAME", "SUDO_USER"})
    if (const char* value = std::getenv(name)) scrubber.addSecret(value);
  if (const passwd* user = ::getpwuid(::getuid())) {
    scrubber.addSecret(user->pw_name);
    scrubber.addSecret(user->pw_gecos);
  }
  if (const char* home = std::getenv("HOME")) scrubber.addSecret(fs::path(home).filename().string());
}

/// The kept camera pairs; what their files name becomes a secret.
std::vector<capture::RigEntry> keptRigs(Scrubber& scrubber) {
  try {
    const capture::RigStore store;
    addSecretsBelow(store.folder().parent_path(), scrubber);
    const auto rigs = store.list();
    for (const auto& entry : rigs) scrubber.addSecret(entry.name);
    return rigs;
  } catch (const Error&) {  // this user has no home folder
    return {};
  }
}

/// The kept camera pairs by what they are, without names, serial numbers and addresses.
Json rigsOf(const std::vector<capture::RigEntry>& rigs, const Scrubber& scrubber) {
  Json list = Json::array();
  for (const auto& entry : rigs) {
    Json json{{"is_readable", bool(entry.rig)}};
    if (!entry.problem.empty()) json["problem"] = scrubber.scrubbed(entry.problem);
    if (entry.rig && entry.rig->left) json["connection"] = entry.rig->left->identity.backend;
    if (entry.rig && entry.rig->last_check) json["last_check"] = entry.rig->last_check->state;
    list.push_back(json);
  }
  return list;
}

/// Takes the secrets out of every text of the JSON; keys are the program's own.
void scrub(Json& json, const Scrubber& scrubber) {
  if (json.is_string()) json = scrubber.withoutSecrets(json.get<std::string>());
  if (json.is_structured())
    for (auto& element : json) scrub(element, scrubber);
}

std::string textOf(Json json, const Scrubber& scrubber) {
  scrub(json, scrubber);
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string scrubbedLog(const fs::path& file, const Scrubber& scrubber) {
  std::istringstream stream(readWholeFile(file));
  std::string out;
  for (std::string line; std::getline(stream, line);) out += scrubber.scrubbed(line) + "\n";
  return out;
}

}  // namespace

ZipEntries supportBundle(const BundleRequest& request) {
  if (request.case_folder && !fs::is_directory(*request.case_folder))
    throw Error("no such case folder", request.case_folder->string(), "give the folder of a case");
  Scrubber scrubber;
  addSecretsOfComputer(scrubber);
  const auto rigs = keptRigs(scrubber);
  if (request.case_folder) addSecretsBelow(*request.case_folder, scrubber);
  Json program = programFacts();
  program["changed settings"] = changedSettings();
  ZipEntries entries{{"README.txt", kReadme},
                     {"program.json", program.dump(1) + "\n"},
                     {"machine.json", textOf(machineFacts(), scrubber)},
                     {"rigs.json", textOf(rigsOf(rigs, scrubber), scrubber)}};
  if (request.case_folder)
    entries["case.json"] = textOf(caseOutline(*request.case_folder, scrubber), scrubber);
  if (request.log) entries["log.txt"] = scrubbedLog(*request.log, scrubber);
  return entries;
}

}  // namespace facenav::app
