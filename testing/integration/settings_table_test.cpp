#include "settings.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <regex>
#include <set>

namespace facenav::steps {
namespace {

std::vector<SettingEntry> all() { return app::allSettings().entries(); }

TEST(Settings, EveryDefaultLiesInItsRange) {
  for (const SettingEntry& entry : all()) {
    EXPECT_LT(entry.setting.minimum, entry.setting.maximum) << entry.key();
    EXPECT_GE(entry.default_value, entry.setting.minimum) << entry.key();
    EXPECT_LE(entry.default_value, entry.setting.maximum) << entry.key();
  }
}

TEST(Settings, EveryOneSaysItsUnitItsMeaningAndItsOrigin) {
  for (const SettingEntry& entry : all()) {
    EXPECT_FALSE(entry.setting.unit.empty()) << entry.key();
    EXPECT_FALSE(entry.setting.help.empty()) << entry.key();
    EXPECT_FALSE(entry.setting.evidence.empty()) << entry.key();
  }
}

/// A fitted number names the data of its fit, and results on other data.
TEST(Settings, EveryFittedOneSaysWhatWasHeldOut) {
  for (const SettingEntry& entry : all()) {
    if (entry.setting.origin != Origin::fitted) continue;
    const std::string& words = entry.setting.evidence;
    const bool is_said =
        words.find("held out") != std::string::npos || words.find("no other head") != std::string::npos ||
        words.find("not used") != std::string::npos || words.find("later") != std::string::npos;
    EXPECT_TRUE(is_said) << entry.key() << ": " << words;
  }
}

/// A unit suffix of a name equals the unit given.
TEST(Settings, NamesAndUnitsAgree) {
  const std::map<std::string, std::string> units{{"mm", "mm"}, {"mm2", "mm2"}, {"px", "px"},   {"s", "s"},
                                                 {"ms", "ms"}, {"rad", "rad"}, {"deg", "deg"}, {"min", "min"},
                                                 {"h", "h"},   {"pct", "%"},   {"uv", "uV"},   {"days", "d"},
                                                 {"ml", "ml"}, {"hz", "Hz"}};
  for (const SettingEntry& entry : all()) {
    const std::string name = entry.setting.name, last = name.substr(name.rfind('_') + 1);
    EXPECT_EQ(entry.setting.unit, units.count(last) ? units.at(last) : "1") << entry.key();
  }
}

TEST(Settings, EveryOneCanBeSetToEitherEndOfItsRange) {
  for (const SettingEntry& entry : all()) {
    SettingsTable table = app::allSettings();
    EXPECT_NO_THROW(table.set(entry.key(), entry.setting.minimum));
    EXPECT_NO_THROW(table.set(entry.key(), entry.setting.maximum));
  }
}

/// The table of gates names settings that exist, and each row states its false alarms and its misses.
TEST(Settings, EveryGateNamesItsSettingsAndItsErrors) {
  std::set<std::string> names;
  for (const SettingEntry& entry : all()) names.insert(entry.key());
  std::ifstream page(std::string(FACENAV_SOURCE_DIR) + "/resources/doc/gates.md");
  const std::regex setting("(registration|head_tracking|monitoring|stereo)\\.([a-z_]+)");
  int gates = 0;
  for (std::string line; std::getline(page, line);) {
    if (line.rfind("| ", 0) != 0 || line.rfind("| gate |", 0) == 0) continue;
    ++gates;
    EXPECT_EQ(std::count(line.begin(), line.end(), '|'), 7) << line;
    EXPECT_EQ(line.find("|  |"), std::string::npos) << "an empty cell: " << line;
    const std::string gate = line.substr(2, line.find(" | ", 2) - 2);
    for (std::sregex_iterator it(gate.begin(), gate.end(), setting), end; it != end; ++it)
      EXPECT_EQ(names.count(it->str()), 1u) << it->str() << " is no setting";
  }
  EXPECT_GT(gates, 20);
}

TEST(Settings, AFlagWinsOverAFileAndTheLaterFlagOverTheEarlier) {
  app::SettingsRequest request;
  request.assignments = {"segmentation.search_mm=9", "segmentation.search_mm=7"};
  EXPECT_EQ(app::settingsFor(request).changed().at("segmentation.search_mm"), 7);
}

}  // namespace
}  // namespace facenav::steps
