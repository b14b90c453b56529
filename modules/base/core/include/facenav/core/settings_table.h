#pragma once
// SettingsTable: all settings that a program knows, as a table: listed, changed by text or by a JSON file,
// checked, and copied back into the typed structs. A key is "module.name".
// A settings file is a JSON object of numbers: {"segmentation.search_mm": 9}.

#include <filesystem>
#include <map>
#include <string>
#include <type_traits>
#include <vector>

#include "facenav/core/setting.h"

namespace facenav {
inline namespace core {

using SettingValues = std::map<std::string, double>;  // by key

struct SettingEntry {
  std::string module, subject;
  Setting setting;
  double default_value = 0, value = 0;
  bool is_whole = false;  // an int

  std::string key() const { return module + "." + setting.name; }
  bool isChanged() const { return value != default_value; }
};

/// Value with its unit, as text: "9 mm", "0.48".
std::string valueInWords(double value, const std::string& unit);

class SettingsTable {
 public:
  /// Table of these groups with their defaults. A name used twice in a module is a bug.
  template <class... Groups>
  static SettingsTable of() {
    SettingsTable table;
    (table.add<Groups>(), ...);
    return table;
  }

  const std::vector<SettingEntry>& entries() const { return entries_; }
  /// Throws Error for an unknown key (with the nearest right one), a value out of range, and a fraction where
  /// a whole number is wanted. `where`: the file or flag, for the message.
  void set(const std::string& key, double value, const std::string& where = {});
  /// Sets a value by "module.name=value". Throws Error as set() does, and for another syntax.
  void setByText(const std::string& assignment);
  /// Reads a settings file. Throws Error as set() does, and for a file of another kind.
  void readFile(const std::filesystem::path& json);
  /// Values that differ from the defaults.
  SettingValues changed() const;

  template <class Group>
  void copyTo(Group& group) const {
    Group::visit(group, [this](const Setting& setting, auto& field) {
      field = static_cast<std::decay_t<decltype(field)>>(
          entry(std::string(Group::kModule) + "." + setting.name).value);
    });
  }

 private:
  template <class Group>
  void add() {
    Group defaults;
    Group::visit(defaults, [this](const Setting& setting, const auto& field) {
      using Number = std::decay_t<decltype(field)>;
      static_assert(std::is_same_v<Number, double> || std::is_same_v<Number, int>,
                    "a setting is a double or an int");
      add({Group::kModule, Group::kSubject, setting, double(field), double(field),
           std::is_same_v<Number, int>});
    });
  }
  void add(SettingEntry entry);
  const SettingEntry& entry(const std::string& key) const;
  std::string nearestKey(const std::string& wrong) const;

  std::vector<SettingEntry> entries_;
};

}  // namespace core
}  // namespace facenav
