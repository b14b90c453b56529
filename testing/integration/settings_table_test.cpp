#include "settings.h"

#include <gmock/gmock.h>

#include <map>

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

TEST(Settings, AFlagWinsOverAFileAndTheLaterFlagOverTheEarlier) {
  app::SettingsRequest request;
  request.assignments = {"segmentation.search_mm=9", "segmentation.search_mm=7"};
  EXPECT_EQ(app::settingsFor(request).changed().at("segmentation.search_mm"), 7);
}

}  // namespace
}  // namespace facenav::steps
