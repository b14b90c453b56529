// Checks the layering: who may include whom, no Qt below ui, no GDCM or PCL in a public header, no Qt in the
// command line tool. The table is read from modules/README.md.

#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

const fs::path kModules = fs::path(FACENAV_SOURCE_DIR) / "modules";

/// Module with its folder and its place in the order of the layers.
struct Module {
  std::string name, folder;
  fs::path path() const { return kModules / folder / name; }
};

/// Reads the table of modules/README.md, lowest module first: lines "modules/<folder>/  module module ..",
/// the lowest folder last.
std::vector<Module> readTable() {
  static const std::regex kLine(R"(^modules/([a-z]+)/ +([a-z_]+(?: [a-z_]+)*))");
  std::vector<std::vector<Module>> folders;
  std::ifstream stream(kModules / "README.md");
  std::smatch match;
  for (std::string line; std::getline(stream, line);) {
    if (!std::regex_search(line, match, kLine)) continue;
    std::vector<Module> modules;
    std::istringstream names(match[2]);
    for (std::string name; names >> name;) modules.push_back({name, match[1]});
    folders.push_back(modules);
  }
  std::vector<Module> table;
  for (auto folder = folders.rbegin(); folder != folders.rend(); ++folder)
    table.insert(table.end(), folder->begin(), folder->end());
  return table;
}

const std::vector<Module>& modules() {
  static const std::vector<Module> kTable = readTable();
  return kTable;
}

std::vector<fs::path> sourcesUnder(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const auto extension = entry.path().extension();
    if (extension == ".h" || extension == ".cpp") files.push_back(entry.path());
  }
  return files;
}

std::vector<std::string> includesOf(const fs::path& file) {
  static const std::regex kInclude(R"(^\s*#\s*include\s*[<"]([^>"]+)[>"])");
  std::vector<std::string> found;
  std::ifstream stream(file);
  std::smatch match;
  for (std::string line; std::getline(stream, line);)
    if (std::regex_search(line, match, kInclude)) found.push_back(match[1]);
  return found;
}

TEST(Layers, EveryModuleStandsInTheTable) {
  std::set<fs::path> named;
  for (const Module& module : modules()) {
    EXPECT_TRUE(fs::is_directory(module.path())) << module.path();
    EXPECT_TRUE(named.insert(module.path()).second) << module.path() << " stands twice";
  }
  for (const auto& folder : fs::directory_iterator(kModules)) {
    if (!folder.is_directory()) continue;
    for (const auto& entry : fs::directory_iterator(folder))
      EXPECT_TRUE(named.count(entry.path())) << entry.path();
  }
}

TEST(Layers, ModulesIncludeOnlyThoseBelowThem) {
  static const std::regex kOurs("^facenav/([a-z_]+)/");
  std::set<std::string> below;
  for (const Module& module : modules()) {
    below.insert(module.name);
    for (const auto& file : sourcesUnder(module.path()))
      for (const auto& include : includesOf(file)) {
        std::smatch match;
        if (!std::regex_search(include, match, kOurs)) continue;
        EXPECT_TRUE(below.count(match[1])) << file << " includes " << include;
      }
  }
}

/// The clinic's programs must not link the laboratory.
TEST(Layers, NobodyOutsideTheLabIncludesIt) {
  std::set<std::string> lab;
  for (const Module& module : modules())
    if (module.folder == "lab") lab.insert(module.name);
  static const std::regex kOurs("^facenav/([a-z_]+)/");
  for (const char* part : {"app", "ui"})
    for (const auto& file : sourcesUnder(fs::path(FACENAV_SOURCE_DIR) / part)) {
      const std::string path = fs::relative(file, FACENAV_SOURCE_DIR).string();
      if (path.rfind("app/lab", 0) == 0 && path != "app/lab_program.cpp") continue;  // part of facenav-lab
      for (const auto& include : includesOf(file)) {
        std::smatch match;
        if (std::regex_search(include, match, kOurs))
          EXPECT_FALSE(lab.count(match[1])) << file << ": " << include;
      }
    }
}

TEST(Layers, NoQtBelowTheWindow) {
  static const std::regex kQt("^(Q[A-Z]|Qt|QVTK)");
  for (const auto& file : sourcesUnder(kModules))
    for (const auto& include : includesOf(file))
      EXPECT_FALSE(std::regex_search(include, kQt)) << file << ": " << include;
}

TEST(Layers, NoGdcmNorPclInAPublicHeader) {
  static const std::regex kHidden("^(gdcm|dcmtk/|pcl/|dlib/|embree)");
  for (const Module& module : modules()) {
    for (const auto& file : sourcesUnder(module.path() / "include"))
      for (const auto& include : includesOf(file))
        EXPECT_FALSE(std::regex_search(include, kHidden)) << file << ": " << include;
  }
}

TEST(Layers, DicomFilesAreReadByGdcmAndTheNetworkIsDcmtk) {
  static const std::regex kGdcm("^gdcm"), kDcmtk("^dcmtk/");
  for (const Module& module : modules())
    for (const auto& file : sourcesUnder(module.path()))
      for (const auto& include : includesOf(file)) {
        if (std::regex_search(include, kGdcm)) EXPECT_EQ(module.name, "dicom") << file << ": " << include;
        if (std::regex_search(include, kDcmtk)) EXPECT_EQ(module.name, "pacs") << file << ": " << include;
      }
}

/// Expects that no line of any module but `home` matches.
void expectOnlyIn(const std::string& home, const std::regex& forbidden) {
  for (const Module& module : modules()) {
    if (module.name == home) continue;
    for (const auto& file : sourcesUnder(module.path())) {
      std::ifstream stream(file);
      int number = 0;
      for (std::string line; std::getline(stream, line);)
        EXPECT_FALSE((++number, std::regex_search(line, forbidden))) << file << ":" << number << ": " << line;
    }
  }
}

TEST(Layers, OnlyCoreStartsProcessesAndSharesOutLoops) {
  // core/child_process.h and core/parallel_for.h enforce rules (no orphan, priority) that other code would
  // not.
  expectOnlyIn("core", std::regex(R"(\b(cv::parallel_for_|fork\(\)|posix_spawn|popen\()|#\s*pragma omp)"));
}

TEST(Layers, DegreesAndRadiansAreConvertedByGeometrysFactors) {
  expectOnlyIn("geometry", std::regex(R"(M_PI ?/ ?180|\b180(\.0?)? ?/ ?M_PI)"));
}

TEST(Layers, OpenCvInPublicHeadersOfImageModulesOnly) {
  const std::set<std::string> allowed{
      "cameras", "stereo", "face",    "head_tracking", "coil_tracking", "health",   "measured_face",
      "setup",   "align",  "capture", "room",          "session",       "pictures", "evaluation"};
  for (const Module& module : modules()) {
    if (allowed.count(module.name)) continue;
    for (const auto& file : sourcesUnder(module.path() / "include"))
      for (const auto& include : includesOf(file))
        EXPECT_NE(include.rfind("opencv2/", 0), 0u) << file << ": " << include;
  }
}

TEST(Layers, CommandLineToolLinksNeitherQtNorTheLaboratory) {
  FILE* pipe = ::popen("ldd '" FACENAV_CLI "-cli' 2>&1", "r");
  ASSERT_NE(pipe, nullptr);
  std::string text;
  char buffer[4096];
  while (std::fgets(buffer, sizeof buffer, pipe)) text += buffer;
  ASSERT_EQ(::pclose(pipe), 0) << text;
  EXPECT_NE(text.find("libvtk"), std::string::npos) << "ldd did not list the tool's libraries";
  EXPECT_EQ(text.find("libQt"), std::string::npos) << text;
}

}  // namespace
