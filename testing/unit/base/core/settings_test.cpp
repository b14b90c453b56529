#include <gmock/gmock.h>

#include <fstream>

#include "facenav/core/child_process.h"
#include "facenav/core/error.h"
#include "facenav/core/frame_work.h"
#include "facenav/core/settings_in_force.h"
#include "support/test_data.h"

namespace facenav {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Pair;

struct Growth {
  static constexpr const char* kModule = "brain";
  static constexpr const char* kSubject = "growth";
  double reach_mm = 8;
  int rounds = 3;

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor(kHeads("reach_mm", 0, 30, "mm", "how far it grows"), self.reach_mm);
    visitor(kHeads("rounds", 1, 9, "1", "how often"), self.rounds);
  }
  static constexpr Evidence kHeads{Origin::fitted, "on three heads, none held out"};
};

struct Limits {
  static constexpr const char* kModule = "face";
  static constexpr const char* kSubject = "limits";
  double share = 0.25;

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor(Evidence{Origin::chosen, "odds"}("share", 0, 1, "1", "of the face"), self.share);
  }
};

SettingsTable table() { return SettingsTable::of<Growth, Limits>(); }

template <class Work>
std::string faultOf(const Work& work) {
  try {
    work();
  } catch (const Error& fault) {
    return fault.what();
  }
  return "";
}

std::string faultOfText(const std::string& assignment) {
  return faultOf([&] { table().setByText(assignment); });
}

TEST(SettingsTable, HoldsDefaultUnitRangeAndOrigin) {
  const auto entries = table().entries();
  ASSERT_EQ(entries.size(), 3u);
  EXPECT_EQ(entries[0].key(), "brain.reach_mm");
  EXPECT_EQ(entries[0].default_value, 8);
  EXPECT_EQ(entries[0].setting.unit, "mm");
  EXPECT_EQ(entries[0].setting.maximum, 30);
  EXPECT_EQ(toString(entries[0].setting.origin), "fitted");
  EXPECT_FALSE(entries[0].is_whole);
  EXPECT_TRUE(entries[1].is_whole);
  EXPECT_THAT(table().changed(), IsEmpty());
}

TEST(SettingsTable, TwoOfOneNameAreABug) {
  EXPECT_THROW((SettingsTable::of<Growth, Limits, Growth>()), std::logic_error);
}

TEST(SettingsTable, WhatIsSetComesBackInTheStruct) {
  SettingsTable changed = table();
  changed.setByText("brain.reach_mm=9.5");
  changed.setByText("brain.rounds=4");
  Growth growth;
  changed.copyTo(growth);
  EXPECT_EQ(growth.reach_mm, 9.5);
  EXPECT_EQ(growth.rounds, 4);
  EXPECT_THAT(changed.changed(), ElementsAre(Pair("brain.reach_mm", 9.5), Pair("brain.rounds", 4)));
  changed.setByText("brain.reach_mm=8");  // the default again
  EXPECT_THAT(changed.changed(), ElementsAre(Pair("brain.rounds", 4)));
}

TEST(SettingsTable, AWrongNameIsAnsweredWithTheNearestRightOne) {
  EXPECT_THAT(faultOfText("brain.raech_mm=9"), HasSubstr("'brain.reach_mm'"));
  EXPECT_THAT(faultOfText("reach_mm=9"), HasSubstr("'brain.reach_mm'"));
  EXPECT_THAT(faultOfText("head.share=0.3"), HasSubstr("'face.share'"));
  EXPECT_THAT(faultOfText("face.shares=0.3"), HasSubstr("'face.share'"));
}

TEST(SettingsTable, AWrongValueIsRefusedWithWhatIsAllowed) {
  EXPECT_THAT(faultOfText("brain.reach_mm=31"), HasSubstr("brain.reach_mm is 31, allowed are 0 to 30 mm"));
  EXPECT_THAT(faultOfText("brain.reach_mm=-1"), HasSubstr("allowed are 0 to 30 mm"));
  EXPECT_THAT(faultOfText("brain.rounds=2.5"), HasSubstr("whole number"));
  for (const char* wrong : {"=", "=nine", "=9mm", "=0,5", "=nan", "=inf", "= "})
    EXPECT_THAT(faultOfText(std::string("brain.reach_mm") + wrong), HasSubstr("is no number")) << wrong;
  EXPECT_THAT(faultOfText("brain.reach_mm"), HasSubstr("module.name=value"));
  EXPECT_THAT(faultOfText("=9"), HasSubstr("module.name=value"));
}

TEST(SettingsTable, AFileChangesSeveral) {
  const testing::TemporaryFolder folder;
  const auto path = folder.path() / "mine.json";
  const auto readOf = [&](const std::string& content) {
    std::ofstream(path) << content;
    SettingsTable changed = table();
    changed.readFile(path);
    return changed.changed();
  };
  EXPECT_THAT(readOf(R"({"brain.reach_mm": 9, "face.share": 0.25})"), ElementsAre(Pair("brain.reach_mm", 9)));
  EXPECT_THAT(readOf("{}"), IsEmpty());
  const auto refusalOf = [&](const std::string& content) { return faultOf([&] { readOf(content); }); };
  EXPECT_THAT(refusalOf(R"({"brain.reach": 9})"), HasSubstr("'brain.reach_mm'"));
  EXPECT_THAT(refusalOf(R"({"brain.reach": 9})"), HasSubstr("mine.json"));
  EXPECT_THAT(refusalOf(R"({"brain.reach_mm": "9"})"), HasSubstr("number"));
  EXPECT_THAT(refusalOf(R"({"brain.reach_mm": 99})"), HasSubstr("mine.json"));
  EXPECT_THAT(refusalOf("[9]"), HasSubstr("object"));
  EXPECT_THAT(refusalOf("brain.reach_mm=9"), HasSubstr("JSON"));
}

/// Failure of `work` in a process of its own, since settings are put in force once.
std::string failureOf(const std::function<void()>& work) { return ChildProcess::run(work).wait().failure; }

void require(bool is_so, const char* what) {
  if (!is_so) throw Error(what);
}

SettingsTable wide() {
  SettingsTable changed = table();
  changed.setByText("brain.reach_mm=9");
  return changed;
}

TEST(SettingsInForce, AreTheDefaultsWithoutMore) {
  EXPECT_EQ(failureOf([] {
              require(settingsOf<Growth>().reach_mm == 8, "default");
              require(changedSettings().empty(), "nothing changed");
            }),
            "");
}

TEST(SettingsInForce, AreWhatTheTableSays) {
  EXPECT_EQ(failureOf([] {
              putInForce<Growth, Limits>(wide());
              require(settingsOf<Growth>().reach_mm == 9, "changed");
              require(settingsOf<Limits>().share == 0.25, "unchanged");
              require(changedSettings() == SettingValues{{"brain.reach_mm", 9}}, "recorded");
              require(changedSettingsInWords().at(0) == "brain.reach_mm 9 mm (default 8)", "said");
            }),
            "");
}

TEST(SettingsInForce, GiveAFrameItsWorkBudget) {
  EXPECT_EQ(failureOf([] {
              SettingsTable budget = SettingsTable::of<FrameBudget>();
              budget.setByText("core.frame_comparisons=9000");
              putInForce<FrameBudget>(budget);
              require(FrameWork{1000}.left() == 8000, "left of the changed budget");
            }),
            "");
}

TEST(SettingsInForce, CannotBeChangedAgain) {
  EXPECT_THAT(failureOf([] {
                putInForce<Growth, Limits>(wide());
                putInForce<Growth, Limits>(table());
              }),
              HasSubstr("only once"));
}

TEST(SettingsInForce, CannotBeChangedAfterAMethodHasReadThem) {
  EXPECT_THAT(failureOf([] {
                require(settingsOf<Limits>().share > 0, "read");
                putInForce<Growth, Limits>(wide());
              }),
              HasSubstr("before any work"));
}

}  // namespace
}  // namespace facenav
