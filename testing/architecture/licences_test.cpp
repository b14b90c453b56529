// The list of parts that others made is whole: each library that a program is linked with has a row with its
// licence, and each row stands for a library that is linked. The SPDX form names the same parts.

#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <set>

#include "facenav/core/licences.h"
#include "support/command_line.h"

namespace facenav::testing {
namespace {

namespace fs = std::filesystem;

/// Libraries that the program itself asks for (DT_NEEDED).
std::set<std::string> librariesOf(const fs::path& program) {
  static const std::regex kNeeded(R"(\(NEEDED\).*\[([^\]]+)\])");
  const std::string text = runProgram("readelf", "-d '" + program.string() + "'").output;
  std::set<std::string> found;
  for (std::sregex_iterator at(text.begin(), text.end(), kNeeded), end; at != end; ++at)
    found.insert((*at)[1]);
  return found;
}

std::set<std::string> linkedLibraries() {
  std::set<std::string> all;
  for (const char* name : {"", "-cli", "-gui", "-lab", "-bids"}) {
    const fs::path program = std::string(FACENAV_CLI) + name;
    if (!fs::exists(program)) continue;  // a build without the window
    const auto libraries = librariesOf(program);
    EXPECT_FALSE(libraries.empty()) << program;
    all.insert(libraries.begin(), libraries.end());
  }
  return all;
}

bool isOf(const std::string& library, const LicensedPart& part) {
  for (const std::string& begin : part.libraries)
    if (library.rfind(begin, 0) == 0) return true;
  return false;
}

TEST(LicencesOfThePrograms, EachLinkedLibraryHasARow) {
  for (const std::string& library : linkedLibraries()) {
    int rows = 0;
    for (const LicensedPart& part : licensedParts()) rows += isOf(library, part);
    EXPECT_EQ(rows, 1) << library << ": rows in resources/licences/parts.txt";
  }
}

TEST(LicencesOfThePrograms, EachRowStandsForALinkedLibrary) {
  const auto libraries = linkedLibraries();
  if (!fs::exists(std::string(FACENAV_CLI) + "-gui")) GTEST_SKIP() << "built without the window";
  for (const LicensedPart& part : licensedParts()) {
    bool is_linked = part.libraries.empty();
    for (const std::string& library : libraries) is_linked |= isOf(library, part);
    EXPECT_TRUE(is_linked) << part.name;
  }
}

TEST(LicencesOfThePrograms, TheVerbPrintsEveryPartAlsoAsSpdx) {
  const auto words = runFacenav("licences"), spdx = runFacenav("licences --spdx");
  EXPECT_EQ(words.status, 0) << words.errors;
  EXPECT_EQ(spdx.status, 0) << spdx.errors;
  for (const LicensedPart& part : licensedParts()) {
    EXPECT_NE(words.output.find(part.name), std::string::npos) << part.name;
    EXPECT_NE(spdx.output.find("\"name\": \"" + part.name + "\""), std::string::npos) << part.name;
    EXPECT_NE(
        spdx.output.find("pkg:deb/debian/" + std::regex_replace(part.package, std::regex("\\+"), "%2B")),
        std::string::npos)
        << part.package;
  }
  EXPECT_NE(spdx.output.find("\"spdxVersion\": \"SPDX-2.3\""), std::string::npos);
}

}  // namespace
}  // namespace facenav::testing
