// Checks that every source of the project has the format of .clang-format. The tool is clang-format of Debian
// 12.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace facenav {
namespace {

namespace fs = std::filesystem;

bool isSource(const fs::path& path) {
  const auto extension = path.extension();
  return extension == ".h" || extension == ".cpp";
}

std::vector<std::string> sources() {
  std::vector<std::string> found;
  for (const char* folder : {"app", "modules", "ui", "testing"}) {
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(FACENAV_SOURCE_DIR) / folder)) {
      if (entry.is_regular_file() && isSource(entry.path())) found.push_back(entry.path().string());
    }
  }
  return found;
}

// The first lines of what a command prints.
std::string firstLines(const std::string& command) {
  std::string text;
  FILE* pipe = popen(command.c_str(), "r");
  if (!pipe) return "the command could not be started";
  char line[512];
  for (int n = 0; std::fgets(line, sizeof line, pipe);) {
    if (n++ < 10) text += line;
  }
  pclose(pipe);
  return text;
}

TEST(Format, EverySourceIsFormatted) {
  if (std::system("clang-format --version >/dev/null 2>&1") != 0)
    GTEST_SKIP() << "clang-format is not installed";
  const auto list = sources();
  ASSERT_GT(list.size(), 500u);
  const auto names = fs::path(::testing::TempDir()) / ("facenav_sources_" + std::to_string(getpid()));
  std::ofstream file(names);
  for (const auto& source : list) file << source << '\n';
  file.close();
  const std::string faults = firstLines("xargs clang-format --dry-run <'" + names.string() +
                                        "' 2>&1 | grep 'code should be clang-formatted'");
  fs::remove(names);
  EXPECT_EQ(faults, "") << "run clang-format -i on the files named above";
}

}  // namespace
}  // namespace facenav
