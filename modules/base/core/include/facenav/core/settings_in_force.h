#pragma once
// The settings in force in this process. They are fixed before the first work: a program puts them in force
// at most once, at its start, and nothing can change them later, least of all during a treatment. Without
// that, the defaults are in force.

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
/// From now on the values stay as they are.
void freeze();
/// Keeps what differs from the defaults. Throws Error when the values may have been read already.
void begin(const SettingsTable& table);
}  // namespace settings_detail

/// The values of one group (a struct as in setting.h). From any thread. A hot path reads them once, when it
/// is made.
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

/// Those in force that differ from their defaults, by key. Empty as a rule.
const SettingValues& changedSettings();

/// "segmentation.search_mm 9 mm (default 8)" for each of them.
const std::vector<std::string>& changedSettingsInWords();

/// "made with changed settings: segmentation.search_mm 9 mm (default 8)"; nothing where none differs.
std::optional<std::string> changedSettingsFinding(const std::string& made);

}  // namespace core
}  // namespace facenav
