// facenav settings [MODULE]: the numbers that were fitted or chosen, with unit, range and origin;
// facenav settings --why NAME: where one of them, or a constant of the code, comes from;
// facenav settings --gates: what refuses or withholds, on what evidence, and how often it is wrong.

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <sstream>

#include "commands/commands.h"
#include "evidence_table.h"
#include "facenav/core/error.h"
#include "json_output.h"
#include "wrong_usage.h"

namespace facenav::app {
namespace {

nlohmann::ordered_json toJson(const SettingEntry& entry) {
  const Setting& setting = entry.setting;
  return {{"name", entry.key()},         {"subject", entry.subject},
          {"value", entry.value},        {"default", entry.default_value},
          {"unit", setting.unit},        {"minimum", setting.minimum},
          {"maximum", setting.maximum},  {"is_whole", entry.is_whole},
          {"help", setting.help},        {"origin", toString(setting.origin)},
          {"evidence", setting.evidence}};
}

void print(const SettingEntry& entry) {
  const Setting& setting = entry.setting;
  const std::string range = valueInWords(setting.minimum, "1") + " to " + valueInWords(setting.maximum, "1");
  const std::string changed =
      entry.isChanged() ? "changed, default " + valueInWords(entry.default_value, "1") + "; " : "";
  std::printf("%s = %s  (%s%s)\n  %s\n  %s: %s\n", entry.key().c_str(),
              valueInWords(entry.value, setting.unit).c_str(), changed.c_str(), range.c_str(),
              setting.help.c_str(), toString(setting.origin).c_str(), setting.evidence.c_str());
}

/// Entries of a module. Throws Error if it has none, with the names of those that have.
std::vector<SettingEntry> entriesOf(const SettingsTable& table, const std::string& module) {
  std::vector<SettingEntry> entries;
  std::set<std::string> modules;
  for (const SettingEntry& entry : table.entries()) {
    modules.insert(entry.module);
    if (module.empty() || entry.module == module) entries.push_back(entry);
  }
  std::string names;
  for (const std::string& name : modules) names += (names.empty() ? "" : ", ") + name;
  if (entries.empty()) throw WrongUsage("no module '" + module + "' has settings", "choose one of: " + names);
  return entries;
}

/// The rows of resources/doc/evidence.md ("| name | evidence |") whose name contains `name`.
std::vector<std::pair<std::string, std::string>> constantsNamed(const std::string& name) {
  std::vector<std::pair<std::string, std::string>> found;
  std::istringstream table(evidenceTable());
  for (std::string line; std::getline(table, line);) {
    const auto middle = line.find(" | ", 2);
    if (line.rfind("| ", 0) != 0 || middle == std::string::npos) continue;
    const std::string constant = line.substr(2, middle - 2);
    if (constant.find(name) == std::string::npos || constant == "name") continue;
    found.emplace_back(constant, line.substr(middle + 3, line.rfind(" |") - middle - 3));
  }
  return found;
}

/// Prints where the settings and constants come from whose names contain `name`. Throws WrongUsage: there is
/// none.
void printWhy(const SettingsTable& table, const std::string& name, bool is_json) {
  auto found = constantsNamed(name);
  std::vector<std::pair<std::string, std::string>> settings;
  for (const SettingEntry& entry : table.entries())
    if (entry.key().find(name) != std::string::npos)
      settings.emplace_back(entry.key(), toString(entry.setting.origin) + ", " + entry.setting.evidence);
  found.insert(found.begin(), settings.begin(), settings.end());
  if (found.empty())
    throw WrongUsage("no setting and no constant with evidence has '" + name + "' in its name",
                     "'facenav settings' lists the settings");
  auto json = nlohmann::ordered_json::array();
  for (const auto& [key, evidence] : found) {
    if (!is_json) std::printf("%s: %s\n", key.c_str(), evidence.c_str());
    json.push_back({{"name", key}, {"evidence", evidence}});
  }
  if (is_json) printJson(json);
}

}  // namespace

void addSettings(CLI::App& app, Context& context) {
  auto* verb =
      app.add_subcommand("settings", "the numbers that were fitted or chosen, and where they come from");
  struct SettingsRequest {
    std::string module;
    bool is_json = false, is_gates = false;
    std::optional<std::string> why;
  };
  auto request = std::make_shared<SettingsRequest>();
  verb->add_option("MODULE", request->module, "only its settings");
  verb->add_flag("--json", request->is_json, "as JSON");
  verb->add_option("--why", request->why,
                   "where a setting or a constant of the code comes from, by a part of its name")
      ->excludes("MODULE");
  verb->add_flag("--gates", request->is_gates,
                 "what refuses, withholds or cautions, on what evidence, and how often it is wrong")
      ->excludes("MODULE")
      ->excludes("--why")
      ->excludes("--json");
  verb->callback([&context, request] {
    if (request->is_gates) return void(std::fputs(gatesTable(), stdout));
    if (request->why) return printWhy(app::settingsFor(context.settings), *request->why, request->is_json);
    const auto entries = entriesOf(app::settingsFor(context.settings), request->module);
    auto json = nlohmann::ordered_json::array();
    std::string subject;
    for (const SettingEntry& entry : entries) {
      if (request->is_json) {
        json.push_back(toJson(entry));
        continue;
      }
      if (entry.subject != subject) std::printf("\n%s: %s\n\n", entry.module.c_str(), entry.subject.c_str());
      subject = entry.subject;
      print(entry);
    }
    if (request->is_json) printJson(json);
  });
}

}  // namespace facenav::app
