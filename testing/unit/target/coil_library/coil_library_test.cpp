#include "facenav/coil_library/coil_library.h"

#include <gmock/gmock.h>

#include <cstdlib>

#include "facenav/core/error.h"
#include "facenav/core/utc_time.h"
#include "facenav/core/whole_file.h"
#include "support/changed_settings.h"
#include "support/refusal.h"
#include "support/test_data.h"

namespace facenav::steps {
namespace {

using ::testing::HasSubstr;
namespace fs = std::filesystem;

std::string coilText(const std::string& name, int id, const std::string& more = "") {
  return R"({"name": ")" + name + R"(", "marker": {"dictionary": "4x4_50", "id": )" + std::to_string(id) +
         R"(, "size_mm": 60}, "marker_T_coil": [1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1])" + more + "}";
}

using facenav::testing::refusalOf;

class CoilLibrary : public ::testing::Test {
 protected:
  fs::path write(const std::string& text) {
    const fs::path file = folder_.path() / "given.json";
    writeWholeFile(file, text);
    return file;
  }
  coil_library::LibraryCoil add(const std::string& name, int id, const std::string& more = "") {
    return coil_library::addCoil(library_, write(coilText(name, id, more)), {}, false);
  }
  facenav::testing::TemporaryFolder folder_;
  fs::path library_ = folder_.path() / "data" / "coils";
};

TEST_F(CoilLibrary, ListsByNameAndFindsByABeginning) {
  EXPECT_TRUE(coil_library::coilsIn(library_).empty());
  EXPECT_THAT(refusalOf([&] { coil_library::findCoil(library_, "x"); }), HasSubstr("facenav coil add"));
  add("figure-8 70 mm", 7);
  add("Double cone", 8);
  const auto coils = coil_library::coilsIn(library_);
  ASSERT_EQ(coils.size(), 2u);
  EXPECT_EQ(coils[0].name, "Double cone");
  EXPECT_EQ(coil_library::findCoil(library_, "double").name, "Double cone");
  EXPECT_EQ(coil_library::findCoil(library_, "figure-8-70-mm").name, "figure-8 70 mm") << "by its folder";
  EXPECT_THAT(refusalOf([&] { coil_library::findCoil(library_, "round"); }),
              HasSubstr("'Double cone', 'figure-8 70 mm'"));
  coil_library::removeCoil(library_, "double");
  EXPECT_EQ(coil_library::coilsIn(library_).size(), 1u);
}

TEST_F(CoilLibrary, TwoCoilsWithOneMarkerAreRefused) {
  add("a", 7);
  EXPECT_THAT(refusalOf([&] { add("b", 7); }), HasSubstr("'a' carries the same marker (4x4_50 id 7)"));
  EXPECT_EQ(coil_library::coilsIn(library_).size(), 1u);
  EXPECT_THAT(refusalOf([&] { add("a", 9); }), HasSubstr("--replace"));
  EXPECT_EQ(coil_library::addCoil(library_, write(coilText("a", 9)), {}, true).model.markers.front().id, 9);
}

TEST_F(CoilLibrary, StatesWhatIsGivenAndTakesMeshAndPatternAlong) {
  writeWholeFile(folder_.path() / "body.stl", "solid");
  coil_library::CoilChanges changes;
  changes.make = "Acme";
  changes.focus_mm = Eigen::Vector3d(0, 5, 0);
  const auto coil = coil_library::addCoil(
      library_, write(coilText("round", 3, R"(, "mesh": "body.stl", "mine": 1)")), changes, false);
  EXPECT_EQ(coil.card.make, "Acme");
  EXPECT_EQ(coil.card.focus_mm.y(), 5);
  EXPECT_NE(coil_library::focusCaution(coil.card).value_or("").find("5 mm beside its centre"),
            std::string::npos);
  auto centred = coil.card;
  centred.focus_mm = {0, 0.4, 20};  // another depth does not change the position on the head
  EXPECT_FALSE(coil_library::focusCaution(centred));
  EXPECT_EQ(*coil.model.mesh, coil.file.parent_path() / "body.stl");
  EXPECT_TRUE(fs::exists(*coil.model.mesh));
  EXPECT_THAT(readWholeFile(coil.file), HasSubstr("\"mine\""));
  EXPECT_THAT(refusalOf([&] { coil_library::addCoil(library_, write(coilText("", 4)), {}, false); }),
              HasSubstr("no name"));
  EXPECT_THAT(refusalOf([&] { add("bad", 4, R"(, "contact_outline_mm": [[1,1],[2,2],[1,2]])"); }),
              HasSubstr("contact_outline_mm"));
}

TEST_F(CoilLibrary, ADamagedCoilIsListedAndSaysWhy) {
  add("good", 7);
  fs::create_directories(library_ / "broken");
  writeWholeFile(library_ / "broken" / "coil.json", "{");
  const auto coils = coil_library::coilsIn(library_);
  ASSERT_EQ(coils.size(), 2u);
  EXPECT_NE(coils[1].problem, "");
  EXPECT_THAT(refusalOf([&] { coil_library::findCoil(library_, "broken"); }), HasSubstr("cannot be used"));
}

TEST_F(CoilLibrary, AWordIsAFileOrAName) {
  add("figure", 7);
  const auto file = write(coilText("given", 8));
  EXPECT_EQ(coil_library::coilFileOf(file.string(), library_), file);
  EXPECT_EQ(coil_library::coilFileOf("figure", library_), library_ / "figure" / "coil.json");
  EXPECT_THAT(refusalOf([&] { coil_library::coilFileOf("absent.json", library_); }),
              HasSubstr("file does not exist"));
}

TEST(CoilReminder, ComesWithAge) {
  coil_tracking::CoilCard card;
  card.name = "c";
  const double made_s = *secondsOfUtc("2026-01-01T00:00:00.000Z");
  EXPECT_THAT(*coil_library::calibrationReminder(card), HasSubstr("no calibration of c is recorded"));
  card.calibration.emplace();
  EXPECT_THAT(*coil_library::calibrationReminder(card), HasSubstr("has no date"));
  card.calibration->utc = "2026-01-01T00:00:00.000Z";
  EXPECT_FALSE(coil_library::calibrationReminder(card, made_s + 179 * 86400.0));
  EXPECT_THAT(*coil_library::calibrationReminder(card, made_s + 213 * 86400.0), HasSubstr("213 days old"));
  facenav::testing::ChangedSettings<coil_library::CoilRules> rules;
  rules->recalibrate_days = 0;
  EXPECT_FALSE(coil_library::calibrationReminder(card, made_s + 9999 * 86400.0));
}

TEST(CoilLibraryFolder, IsAskedForElseByEnvironmentElseTheUsersDataFolder) {
  ::setenv("FACENAV_COILS", "/a/b", 1);
  EXPECT_EQ(coil_library::coilLibrary(), "/a/b");
  EXPECT_EQ(coil_library::coilLibrary("/c"), "/c");
  ::unsetenv("FACENAV_COILS");
  const char* before = std::getenv("XDG_DATA_HOME");
  const std::string kept = before ? before : "";
  ::setenv("XDG_DATA_HOME", "/data", 1);
  EXPECT_EQ(coil_library::coilLibrary(), "/data/facenav/coils");
  kept.empty() ? ::unsetenv("XDG_DATA_HOME") : ::setenv("XDG_DATA_HOME", kept.c_str(), 1);
}

}  // namespace
}  // namespace facenav::steps
