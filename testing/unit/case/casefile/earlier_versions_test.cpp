// Cases of earlier versions open with what they hold; one of a newer version is refused in words and is not
// touched. The text files in earlier/ are as those versions wrote them.

#include <gtest/gtest.h>

#include "facenav/casefile/case_store.h"
#include "facenav/casefile/kept_session.h"
#include "facenav/casefile/poses_csv.h"
#include "facenav/core/error.h"
#include "facenav/core/whole_file.h"
#include "facenav/guidance/target.h"
#include "made_case.h"
#include "support/test_data.h"

namespace facenav::casefile {
namespace {
namespace fs = std::filesystem;
using facenav::testing::TemporaryFolder;

/// A case of an earlier version: its own text files, and today's images.
class EarlierCase {
 public:
  explicit EarlierCase(const std::string& version) {
    if (version == "5_face") {
      FaceCase face;
      face.face = testing::preparedCase().scalp;
      CaseStore::createFromFace(path(), face, {}, false);
    } else {
      CaseStore::create(path(), testing::preparedCase(), {}, false);
    }
    const fs::path texts = fs::path(FACENAV_SOURCE_DIR) / "testing/unit/case/casefile/earlier" / version;
    fs::copy(texts, path(), fs::copy_options::recursive | fs::copy_options::overwrite_existing);
  }
  fs::path path() const { return folder_.path() / "case"; }

 private:
  TemporaryFolder folder_;
};

/// Each file below the folder with its content and its time of change.
std::map<fs::path, std::pair<std::string, fs::file_time_type>> contentOf(const fs::path& folder) {
  std::map<fs::path, std::pair<std::string, fs::file_time_type>> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    files[entry.path()] = {entry.is_regular_file() ? readWholeFile(entry.path()) : "",
                           entry.last_write_time()};
  return files;
}

std::string refusalOf(const std::function<void()>& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

TEST(EarlierVersions, EachOfThemOpens) {
  for (const char* version : {"1_first", "2_doubt", "3_label", "4_settings", "5_face"}) {
    const EarlierCase earlier(version);
    ASSERT_EQ(refusalOf([&] { CaseStore::open(earlier.path()); }), "") << version;
    const auto store = CaseStore::open(earlier.path());
    EXPECT_EQ(store.caseId(), "0123456789abcdef") << version;
    EXPECT_EQ(store.provenance().size(), 1u) << version;
    EXPECT_EQ(store.hasMri(), std::string(version) != "5_face") << version;
  }
}

TEST(EarlierVersions, TheFirstOneGivesItsPlanItsAlignmentAndItsSession) {
  const EarlierCase earlier("1_first");
  const auto store = CaseStore::open(earlier.path());
  EXPECT_EQ(store.label(), "");
  ASSERT_EQ(store.targets().targets.size(), 1u);
  EXPECT_EQ(store.targets().targets[0].name, "M1 hand L");
  ASSERT_TRUE(store.alignment());
  EXPECT_EQ(store.alignment()->points, 4200);
  EXPECT_TRUE(store.alignment()->predicted_tre_p95_mm.empty());
  const auto sessions = sessionFolders(earlier.path());
  ASSERT_EQ(sessions.size(), 1u);
  EXPECT_EQ(readPoses(sessions[0] / "poses.csv").size(), 2u);
  const auto session = readSession(sessions[0]);
  EXPECT_EQ(session.events.size(), 3u);
  EXPECT_EQ(session.pulses.pulses.size(), 1u) << "from the events: there was no pulses.jsonl";
  EXPECT_TRUE(session.pulses.problems.empty());
}

TEST(EarlierVersions, LaterOnesGiveTheirLabelAndTheirSettings) {
  const EarlierCase labelled("3_label"), changed("4_settings");
  EXPECT_EQ(CaseStore::open(labelled.path()).label(), "Case 12");
  EXPECT_EQ(CaseStore::open(changed.path()).provenance()[0].settings.at("segmentation.search_mm"), 9.5);
}

TEST(EarlierVersions, AStepOnAnEarlierCaseLeavesItsOtherFilesAsTheyWere) {
  const EarlierCase earlier("1_first");
  const auto before = contentOf(earlier.path());
  CaseStore::open(earlier.path()).setTargets(testing::onePlan());
  const auto after = contentOf(earlier.path());
  for (const auto& [path, content] : before)
    if (fs::is_regular_file(path) && path.filename() != "targets.json") {
      EXPECT_EQ(after.at(path).first, content.first) << path;
    }
}

/// Remains of a killed program, which opening a case of this version would remove.
void addOldRemains(const fs::path& case_folder) {
  const fs::path group = case_folder / ".tmp999999999_0_group";
  fs::create_directories(group / "new");
  for (const auto& place : {group / "new", group})
    fs::last_write_time(place, fs::file_time_type::clock::now() - std::chrono::hours(25));
}

TEST(NewerVersion, IsRefusedInWordsAndNotTouched) {
  const EarlierCase made("1_first");
  writeWholeFile(made.path() / "case.json",
                 R"({"schema_version": 2, "case_id": {"of a": "later form"}, "files": 7})");
  addOldRemains(made.path());
  const auto before = contentOf(made.path());
  const auto prepared = testing::preparedCase();
  for (const auto& action : std::vector<std::function<void()>>{
           [&] { CaseStore::open(made.path()); }, [&] { CaseStore::openToReplace(made.path()); },
           [&] { CaseStore::create(made.path(), prepared, {}, true); }}) {
    const std::string words = refusalOf(action);
    EXPECT_NE(words.find("newer FaceNav"), std::string::npos) << words;
    EXPECT_NE(words.find("update FaceNav"), std::string::npos) << words;
    EXPECT_EQ(contentOf(made.path()), before);
  }
}

TEST(NewerVersion, AnUnknownOlderOneIsToldApart) {
  const EarlierCase made("1_first");
  writeWholeFile(made.path() / "case.json", R"({"schema_version": 0, "case_id": "x"})");
  const std::string words = refusalOf([&] { CaseStore::open(made.path()); });
  EXPECT_NE(words.find("schema version 0"), std::string::npos) << words;
  EXPECT_EQ(words.find("newer"), std::string::npos) << words;
}

}  // namespace
}  // namespace facenav::casefile
