// The table of hazards is true: each guard that it names is a file, and each test that it names is one.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

#include "support/run_program.h"

namespace facenav::testing {
namespace {

namespace fs = std::filesystem;

const fs::path kSource = FACENAV_SOURCE_DIR;

struct Hazard {
  std::string name;
  std::vector<std::string> files, tests;
};

std::vector<std::string> inBackticks(const std::string& text) {
  static const std::regex kQuoted("`([^`]+)`");
  std::vector<std::string> found;
  for (std::sregex_iterator at(text.begin(), text.end(), kQuoted), end; at != end; ++at)
    found.push_back((*at)[1]);
  return found;
}

/// Rows of the page's table with five columns.
std::vector<Hazard> hazards() {
  std::vector<Hazard> rows;
  std::istringstream page(readText(kSource / "resources/doc/safety.md"));
  for (std::string line; std::getline(page, line);) {
    std::vector<std::string> cells;
    std::istringstream row(line);
    for (std::string cell; std::getline(row, cell, '|');) cells.push_back(cell);
    if (cells.size() != 6 || cells[1] == " hazard " || cells[1] == "---") continue;
    rows.push_back({cells[1], inBackticks(cells[4]), inBackticks(cells[5])});
  }
  return rows;
}

/// "Suite.Name" of every test in testing/.
std::set<std::string> testsOfTheProject() {
  static const std::regex kTest(R"(TEST(?:_F|_P)?\(\s*(\w+),\s*(\w+)\))");
  std::set<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(kSource / "testing")) {
    if (entry.path().extension() != ".cpp" && entry.path().extension() != ".h") continue;
    const std::string text = readText(entry.path());
    for (std::sregex_iterator at(text.begin(), text.end(), kTest), end; at != end; ++at)
      names.insert(at->str(1) + "." + at->str(2));
  }
  return names;
}

TEST(Safety, EachHazardHasAGuardThatExistsAndATestThatExists) {
  const auto rows = hazards();
  ASSERT_GE(rows.size(), 20u);
  const auto tests = testsOfTheProject();
  ASSERT_GT(tests.size(), 2000u);
  for (const Hazard& hazard : rows) {
    EXPECT_FALSE(hazard.files.empty()) << hazard.name;
    EXPECT_FALSE(hazard.tests.empty()) << hazard.name;
    for (const auto& file : hazard.files)
      EXPECT_TRUE(fs::exists(kSource / file)) << hazard.name << ": " << file;
    for (const auto& test : hazard.tests) EXPECT_TRUE(tests.count(test)) << hazard.name << ": " << test;
  }
}

TEST(Safety, ThePageNamesEveryKindOfHazardThatIsKnown) {
  for (const char* kind :
       {"wrong side", "wrong patient", "stale pose", "mirrored pose", "wrong coil", "wrong scan",
        "unit errors", "silent failure", "wrong dose", "moved camera", "drifted pose",
        "a file of another navigator", "a network link", "lost data", "a case of another version"}) {
    int named = 0;
    for (const Hazard& hazard : hazards()) named += hazard.name.find(kind) == 1;
    EXPECT_GE(named, 1) << kind;
  }
}

}  // namespace
}  // namespace facenav::testing
