#pragma once
// The settings in force in this process. They are fixed before the first work: a program puts them in force
// at most once, at its start, and nothing can change them later, least of all during a treatment. Otherwise
// the defaults are in force.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "facenav/core/settings_table.h"

namespace facenav {
inline namespace core {

namespace settings_detail {
template <class Group>
inline Group values{};
/// Forbids later changes of the values.
void freeze();
/// Keeps what differs from the defaults. Throws Error when the values may have been read already.
void begin(const SettingsTable& table);
}  // namespace settings_detail

/// Values of one group (a struct as in setting.h). Thread-safe. A hot path reads them once, at construction.
template <class Group>
const Group& settingsOf() {
  settings_detail::freeze();
  return settings_detail::values<Group>;
}

/// Puts the table's values of these groups in force. Throws Error when that was done before, and when a
/// setting has been read before.
template <class... Groups>
void putInForce(const SettingsTable& table) {
  settings_detail::begin(table);
  (table.copyTo(settings_detail::values<Groups>), ...);
}

/// Settings in force that differ from their defaults, by key. Usually none.
const SettingValues& changedSettings();

/// Text for each changed setting: "segmentation.search_mm 9 mm (default 8)".
const std::vector<std::string>& changedSettingsInWords();

/// Finding for a result: "made with changed settings: segmentation.search_mm 9 mm (default 8)"; nullopt if
/// none differs.
std::optional<std::string> changedSettingsFinding(const std::string& made);

}  // namespace core
}  // namespace facenav
