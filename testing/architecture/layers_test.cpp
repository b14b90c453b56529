// The layering as a test: who may include whom, no Qt below ui, no GDCM or PCL in a public header, no Qt in
// the command line tool. The table is modules/README.md's; the two are changed together.

#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

// Direct dependencies; what they may use in turn is added transitively.
const std::map<std::string, std::set<std::string>> kMayUse{
    {"core", {}},
    {"geometry", {"core"}},
    {"pacs", {"core"}},
    {"links", {"core"}},
    {"sounds", {"core"}},
    {"stimulation", {"geometry"}},
    {"anatomy", {"geometry"}},
    {"volume", {"geometry"}},
    {"cameras", {"geometry"}},
    {"stereo", {"cameras"}},
    {"face", {"cameras"}},
    {"dicom", {"volume"}},
    {"segmentation", {"volume", "anatomy"}},
    {"editing", {"volume"}},
    {"surface", {"volume", "anatomy"}},
    {"atlas", {"volume"}},
    {"capture", {"cameras"}},
    {"registration", {"anatomy"}},
    {"head_tracking", {"face", "stereo"}},
    {"coil_tracking", {"cameras"}},
    {"guidance", {"surface"}},
    {"casefile", {"volume", "surface", "atlas", "cameras", "registration", "guidance", "stimulation"}},
    {"monitoring", {"head_tracking", "coil_tracking", "registration"}},
    {"session", {"capture", "monitoring", "guidance", "casefile", "segmentation", "links"}},
    {"pictures", {"session", "surface", "registration"}},
    {"evaluation", {"casefile", "capture", "stereo"}},
    {"scene", {"volume", "surface", "guidance"}},
    {"room", {"capture", "surface", "stereo"}},
    {"workflow", {"session", "pictures", "scene", "dicom", "editing", "registration"}},
};

std::set<std::string> reachable(const std::string& module) {
  std::set<std::string> all{module};
  for (const auto& direct : kMayUse.at(module))
    for (const auto& name : reachable(direct)) all.insert(name);
  return all;
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

const fs::path kModules = fs::path(FACENAV_SOURCE_DIR) / "modules";

TEST(Layers, EveryModuleStandsInTheTable) {
  for (const auto& entry : fs::directory_iterator(kModules)) {
    if (!entry.is_directory()) continue;
    EXPECT_TRUE(kMayUse.count(entry.path().filename())) << entry.path();
  }
}

TEST(Layers, ModulesIncludeOnlyWhatTheTableAllows) {
  static const std::regex kOurs("^facenav/([a-z_]+)/");
  for (const auto& [module, ignored] : kMayUse) {
    const auto allowed = reachable(module);
    for (const auto& file : sourcesUnder(kModules / module))
      for (const auto& include : includesOf(file)) {
        std::smatch match;
        if (!std::regex_search(include, match, kOurs)) continue;
        EXPECT_TRUE(allowed.count(match[1])) << file << " includes " << include;
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
  for (const auto& entry : fs::directory_iterator(kModules)) {
    if (!entry.is_directory()) continue;
    for (const auto& file : sourcesUnder(entry.path() / "include"))
      for (const auto& include : includesOf(file))
        EXPECT_FALSE(std::regex_search(include, kHidden)) << file << ": " << include;
  }
}

TEST(Layers, DicomFilesAreReadByGdcmAndTheNetworkIsDcmtk) {
  static const std::regex kGdcm("^gdcm"), kDcmtk("^dcmtk/");
  for (const auto& [module, ignored] : kMayUse)
    for (const auto& file : sourcesUnder(kModules / module))
      for (const auto& include : includesOf(file)) {
        if (std::regex_search(include, kGdcm)) EXPECT_EQ(module, "dicom") << file << ": " << include;
        if (std::regex_search(include, kDcmtk)) EXPECT_EQ(module, "pacs") << file << ": " << include;
      }
}

/// No line of any module but `home` may match.
void expectOnlyIn(const std::string& home, const std::regex& forbidden) {
  for (const auto& [module, ignored] : kMayUse) {
    if (module == home) continue;
    for (const auto& file : sourcesUnder(kModules / module)) {
      std::ifstream stream(file);
      int number = 0;
      for (std::string line; std::getline(stream, line);)
        EXPECT_FALSE((++number, std::regex_search(line, forbidden))) << file << ":" << number << ": " << line;
    }
  }
}

TEST(Layers, OnlyCoreStartsProcessesAndSharesOutLoops) {
  // core/child_process.h and core/parallel_for.h keep rules (no orphan, priority) that others would not.
  expectOnlyIn("core", std::regex(R"(\b(cv::parallel_for_|fork\(\)|posix_spawn|popen\()|#\s*pragma omp)"));
}

TEST(Layers, DegreesAndRadiansAreConvertedByGeometrysFactors) {
  expectOnlyIn("geometry", std::regex(R"(M_PI ?/ ?180|\b180(\.0?)? ?/ ?M_PI)"));
}

TEST(Layers, OpenCvInPublicHeadersOfImageModulesOnly) {
  const std::set<std::string> allowed{"cameras", "stereo", "face",    "head_tracking", "coil_tracking",
                                      "capture", "room",   "session", "pictures",      "evaluation"};
  for (const auto& [module, ignored] : kMayUse) {
    if (allowed.count(module)) continue;
    for (const auto& file : sourcesUnder(kModules / module / "include"))
      for (const auto& include : includesOf(file))
        EXPECT_NE(include.rfind("opencv2/", 0), 0u) << file << ": " << include;
  }
}

TEST(Layers, CommandLineToolLinksNoQt) {
  FILE* pipe = ::popen("ldd '" FACENAV_CLI "' 2>&1", "r");
  ASSERT_NE(pipe, nullptr);
  std::string text;
  char buffer[4096];
  while (std::fgets(buffer, sizeof buffer, pipe)) text += buffer;
  ASSERT_EQ(::pclose(pipe), 0) << text;
  EXPECT_NE(text.find("libvtk"), std::string::npos) << "ldd did not list the tool's libraries";
  EXPECT_EQ(text.find("libQt"), std::string::npos) << text;
}

}  // namespace
