#include "facenav/core/settings_in_force.h"

#include <atomic>

#include "facenav/core/error.h"

namespace facenav {
inline namespace core {
namespace {

std::atomic<bool> g_is_frozen{false};

struct Changed {
  SettingValues values;
  std::vector<std::string> words;
};

Changed& changed() {
  static Changed kept;
  return kept;
}

}  // namespace

namespace settings_detail {

void freeze() {
  // A plain load first: threads that read settings share the line.
  if (!g_is_frozen.load(std::memory_order_relaxed)) g_is_frozen.store(true, std::memory_order_relaxed);
}

void begin(const SettingsTable& table) {
  if (g_is_frozen.exchange(true))
    throw Error("settings can be put in force only once, before any work", {}, "restart the program");
  changed().values = table.changed();
  for (const SettingEntry& entry : table.entries())
    if (entry.isChanged())
      changed().words.push_back(entry.key() + " " + valueInWords(entry.value, entry.setting.unit) +
                                " (default " + valueInWords(entry.default_value, "1") + ")");
}

}  // namespace settings_detail

const SettingValues& changedSettings() { return changed().values; }

const std::vector<std::string>& changedSettingsInWords() { return changed().words; }

std::optional<std::string> changedSettingsFinding(const std::string& made) {
  std::string words;
  for (const std::string& setting : changedSettingsInWords()) words += (words.empty() ? "" : ", ") + setting;
  if (words.empty()) return std::nullopt;
  return made + " with changed settings: " + words;
}

}  // namespace core
}  // namespace facenav
