#include "facenav/core/settings_table.h"

#include <algorithm>
#include <cmath>

#include "facenav/core/error.h"
#include "facenav/core/json_reader.h"
#include "facenav/core/near_name.h"
#include "facenav/core/number_text.h"

namespace facenav {
inline namespace core {
namespace {

std::string afterPoint(const std::string& key) { return key.substr(key.find('.') + 1); }

}  // namespace

std::string toString(Origin origin) {
  switch (origin) {
    case Origin::physics:
      return "physics";
    case Origin::article:
      return "article";
    case Origin::fitted:
      return "fitted";
    case Origin::chosen:
      break;
  }
  return "chosen";
}

std::string valueInWords(double value, const std::string& unit) {
  return formatted("%.10g", value) + (unit == "1" ? "" : " " + unit);
}

void SettingsTable::add(SettingEntry entry) {
  for (const SettingEntry& other : entries_)
    FACENAV_EXPECT(other.key() != entry.key(), "two settings are called " + entry.key());
  entries_.push_back(std::move(entry));
}

std::string SettingsTable::nearestKey(const std::string& wrong) const {
  // Compares the name alone too, so that a forgotten or wrong module adds no distance.
  const auto apart = [&wrong](const SettingEntry& entry) {
    return std::min(lettersApart(wrong, entry.key()),
                    1 + lettersApart(afterPoint(wrong), entry.setting.name));
  };
  const auto nearest = std::min_element(entries_.begin(), entries_.end(),
                                        [&](const auto& a, const auto& b) { return apart(a) < apart(b); });
  return nearest == entries_.end() ? "" : nearest->key();
}

void SettingsTable::set(const std::string& key, double value, const std::string& where) {
  const auto found = std::find_if(entries_.begin(), entries_.end(),
                                  [&key](const SettingEntry& entry) { return entry.key() == key; });
  if (found == entries_.end())
    throw Error("there is no setting '" + key + "', the nearest is '" + nearestKey(key) + "'", where,
                "'facenav settings' lists them");
  const Setting& setting = found->setting;
  if (found->is_whole && value != std::floor(value))
    throw Error(key + " takes a whole number, not " + valueInWords(value, "1"), where);
  if (!(value >= setting.minimum && value <= setting.maximum))
    throw Error(key + " is " + valueInWords(value, "1") + ", allowed are " +
                    valueInWords(setting.minimum, "1") + " to " + valueInWords(setting.maximum, setting.unit),
                where);
  found->value = value;
}

void SettingsTable::setByText(const std::string& assignment) {
  const std::size_t equals = assignment.find('=');
  if (equals == std::string::npos || equals == 0)
    throw Error("'" + assignment + "' is not written as module.name=value", "--set");
  const auto value = numberIn(assignment.substr(equals + 1));
  if (!value)
    throw Error("'" + assignment.substr(equals + 1) + "' is no number", "--set " + assignment,
                "write it with a decimal point and without its unit");
  set(assignment.substr(0, equals), *value, "--set " + assignment);
}

void SettingsTable::readFile(const std::filesystem::path& json) {
  for (const auto& [key, value] : JsonReader::readFile(json).members())
    set(key, value.number(), json.string());
}

SettingValues SettingsTable::changed() const {
  SettingValues values;
  for (const SettingEntry& entry : entries_)
    if (entry.isChanged()) values[entry.key()] = entry.value;
  return values;
}

const SettingEntry& SettingsTable::entry(const std::string& key) const {
  for (const SettingEntry& entry : entries_)
    if (entry.key() == key) return entry;
  expectationFailed("entry", __FILE__, __LINE__, "the table lacks " + key);
}

}  // namespace core
}  // namespace facenav
