// Settings from a flag or file to the result and its record, through the command line tool.

#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "facenav/casefile/case_store.h"
#include "support/command_line.h"

namespace facenav::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Pair;

class SettingsOfTheProgram : public ::testing::Test {
 protected:
  std::string at(const std::string& name) const { return (folder_.path() / name).string(); }
  /// Error message of a prepare that must be refused for its settings, before any work.
  std::string refusalOf(const std::string& flags, int status = 2) const {
    const auto result = runFacenav("prepare " + at("none.nii.gz") + " -o " + at("case") + " " + flags);
    EXPECT_EQ(result.status, status) << flags;
    EXPECT_EQ(std::count(result.errors.begin(), result.errors.end(), '\n'), 1) << result.errors;
    EXPECT_FALSE(fs::exists(at("case"))) << flags;
    return result.errors;
  }
  TemporaryFolder folder_;
};

TEST_F(SettingsOfTheProgram, AreListedWithUnitRangeAndOrigin) {
  const auto listed = runFacenav("settings segmentation");
  EXPECT_EQ(listed.status, 0);
  EXPECT_THAT(listed.output, HasSubstr("segmentation.search_mm = 8 mm  (0 to 30)"));
  EXPECT_THAT(listed.output, HasSubstr("fitted: on three heads"));
  EXPECT_EQ(listed.output.find("registration."), std::string::npos);
  EXPECT_THAT(runFacenav("settings").output, HasSubstr("registration.loose_mm = 0.6 mm"));
  const auto unknown = runFacenav("settings segmentations");
  EXPECT_EQ(unknown.status, 2);
  EXPECT_THAT(unknown.errors, HasSubstr("registration, segmentation"));
}

TEST_F(SettingsOfTheProgram, AreListedAsJsonWithWhatIsChanged) {
  const auto listed = runFacenav("settings segmentation --json --quiet --set segmentation.search_mm=9");
  const auto json = nlohmann::json::parse(listed.output);
  ASSERT_FALSE(json.empty());
  EXPECT_EQ(json[0]["name"], "segmentation.search_mm");
  EXPECT_EQ(json[0]["value"], 9);
  EXPECT_EQ(json[0]["default"], 8);
  EXPECT_EQ(json[0]["unit"], "mm");
  EXPECT_EQ(json[0]["origin"], "fitted");
}

TEST_F(SettingsOfTheProgram, ThatAreWrongAreRefusedInOneLine) {
  EXPECT_THAT(refusalOf("--set segmentation.serch_mm=9"), HasSubstr("'segmentation.search_mm'"));
  EXPECT_THAT(refusalOf("--set segmentation.search_mm=99"), HasSubstr("allowed are 0 to 30 mm"));
  EXPECT_THAT(refusalOf("--set segmentation.search_mm=wide"), HasSubstr("'wide' is no number"));
  EXPECT_THAT(refusalOf("--set head_tracking.step_fewest=60.5"), HasSubstr("whole number"));
  EXPECT_THAT(refusalOf("--settings " + at("mine.json"), 1), HasSubstr("mine.json"));
  std::ofstream(at("mine.json")) << R"({"segmentation.search_mm": "9"})";
  EXPECT_THAT(refusalOf("--settings " + at("mine.json"), 1), HasSubstr("segmentation.search_mm"));
  std::ofstream(at("mine.json")) << R"({"segmentation.search": 9})";
  EXPECT_THAT(refusalOf("--settings " + at("mine.json"), 1), HasSubstr("'segmentation.search_mm'"));
}

/// Colin27's brain measures 1768 +- 50 ml with the defaults (brain_real_heads_test).
TEST_F(SettingsOfTheProgram, ThatDifferChangeTheBrainAndAreRecordedWithIt) {
  FACENAV_NEEDS(colin27());
  std::ofstream(at("mine.json")) << R"({"segmentation.core_share": 0.8, "segmentation.tissue_share": 0.35})";
  const auto made = runFacenav("prepare " + colin27().string() + " -o " + at("case") + " --settings " +
                               at("mine.json") + " --set segmentation.tissue_share=0.7");
  ASSERT_EQ(made.status, 0) << made.errors;
  const auto store = casefile::CaseStore::open(at("case"));
  EXPECT_LT(store.brainMask()->volume_ml(), 1750);  // 1791 ml with the defaults
  EXPECT_THAT(store.provenance().at(0).settings,
              ElementsAre(Pair("segmentation.core_share", 0.8), Pair("segmentation.tissue_share", 0.7)));
  const auto said = HasSubstr(
      "made with changed settings: segmentation.core_share 0.8 (default 0.48), "
      "segmentation.tissue_share 0.7 (default 0.35)");
  EXPECT_THAT(store.findings(), Contains(said));
  EXPECT_THAT(runFacenav("check " + at("case")).output, said);
}

}  // namespace
}  // namespace facenav::testing
