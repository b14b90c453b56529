// facenav, the program that people call. It reads its first words and becomes the program that does the work:
// the window, the verbs of the clinic, or the laboratory. It answers --version itself, because the libraries
// of the others take longer to load.

#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include "lab_verbs.h"
#include "software_commit.h"

namespace {

namespace fs = std::filesystem;

fs::path folder() {
  std::error_code error;
  const auto path = fs::read_symlink("/proc/self/exe", error);
  return error ? fs::path() : path.parent_path();
}

int become(const char* name, char** argv, const std::string& advice) {
  const fs::path program = folder() / name;
  ::execv(program.c_str(), argv);
  std::fprintf(stderr, "facenav: %s is not installed beside this program (%s); %s\n", name, program.c_str(),
               advice.c_str());
  return 1;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace facenav;
  const std::vector<std::string> words(argv + 1, argv + argc);
  if (words.size() == 1 && words[0] == "--version") {
    std::printf("%s\n", app::versionInWords().c_str());
    return 0;
  }
  if (words.empty()) return become("facenav-gui", argv, "'facenav --help' lists the verbs");
  if (app::isForLab(words))
    return become("facenav-lab", argv, "install the package facenav-lab, or build it by './facenav.sh demo'");
  return become("facenav-cli", argv, "build or install it again");
}
