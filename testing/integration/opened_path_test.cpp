// What the desktop gives the window: a file that was clicked on, or a folder.

#include "opened_path.h"

#include <gtest/gtest.h>

#include "facenav/core/whole_file.h"
#include "support/test_data.h"
#include "wrong_usage.h"

namespace facenav::testing {
namespace {

TEST(OpenedPath, TellsCasesRecordingsAndHomeCasesApart) {
  const TemporaryFolder folder;
  const auto place = [&](const char* name) { return folder.path() / name; };
  for (const char* name : {"case", "home", "film"}) std::filesystem::create_directory(place(name));
  writeWholeFile(place("case") / "case.json", "{}");
  writeWholeFile(place("home") / "case.json", "{}");
  writeWholeFile(place("home") / "home.json", "{}");
  writeWholeFile(place("film") / "stereo.yml", "%YAML:1.0");
  EXPECT_EQ(app::openedPath(place("case")).case_folder, place("case"));
  EXPECT_EQ(app::openedPath(place("case") / "case.json").case_folder, place("case"));
  EXPECT_EQ(app::openedPath(place("film")).recording, place("film"));
  EXPECT_EQ(app::openedPath(place("film") / "stereo.yml").recording, place("film"));
  EXPECT_EQ(app::openedPath(place("home") / "home.json").home, place("home"));
  EXPECT_EQ(app::openedPath(place("home") / "case.json").case_folder, place("home"));
}

TEST(OpenedPath, RefusesWhatIsNeitherCaseNorRecording) {
  const TemporaryFolder folder;
  writeWholeFile(folder.path() / "notes.txt", "x");
  writeWholeFile(folder.path() / "case.json", "{}");
  EXPECT_THROW(app::openedPath(folder.path() / "notes.txt"), app::WrongUsage);
  EXPECT_THROW(app::openedPath(folder.path() / "none"), app::WrongUsage);
}

}  // namespace
}  // namespace facenav::testing
