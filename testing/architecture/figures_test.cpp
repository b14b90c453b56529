// Words in figures have one owner each: in show/pictures drawn_words.cpp, in show/scene scene_text.h. Words
// that are drawn elsewhere would stay English in a window of another language.

#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <set>
#include <string>

#include "support/run_program.h"

namespace facenav::testing {
namespace {

namespace fs = std::filesystem;

const fs::path kTree = FACENAV_SOURCE_DIR;

/// The files below `folder` whose text matches, but for those of the laboratory, which no window links.
std::set<std::string> filesWith(const char* folder, const std::regex& what) {
  std::set<std::string> found;
  for (const auto& entry : fs::recursive_directory_iterator(kTree / folder)) {
    const std::string place = entry.path().lexically_relative(kTree).generic_string();
    const bool is_source = entry.path().extension() == ".cpp" || entry.path().extension() == ".h";
    if (is_source && place.find("lab/") == std::string::npos &&
        std::regex_search(readText(entry.path()), what))
      found.insert(place);
  }
  return found;
}

using Places = std::set<std::string>;

TEST(FiguresWords, OpenCvsLettersAreDrawnInOnePlace) {
  const std::regex draws("cv::(putText|getTextSize|addText)\\s*\\(");
  const std::string owner = "modules/show/pictures/src/drawn_words.cpp";
  EXPECT_EQ(filesWith("modules", draws), Places{owner});
  EXPECT_EQ(filesWith("ui", draws), Places{});
}

TEST(FiguresWords, VtksTextsGetTheirWordsInOnePlace) {
  const std::regex is_text(
      "vtk(TextActor|TextMapper|TextProperty|BillboardText|Caption|CornerAnnotation|ScalarBar|Legend|Axis)"
      "\\w*\\.h"),
      gives("[.>]SetInput\\(|SetTitle\\(|SetCaption\\(|SetText\\(");
  for (const auto& file : filesWith("modules", is_text))
    EXPECT_FALSE(std::regex_search(readText(kTree / file), gives))
        << file << ": call setWords of scene_text.h";
  EXPECT_GE(filesWith("modules", is_text).size(), 4u) << "the search finds the texts";
  EXPECT_EQ(filesWith("ui", is_text), Places{});
}

// Such pictures are written into files, which stay English.
TEST(FiguresWords, TheWindowShowsNoPictureWithAFilesWords) {
  const Places of_files = filesWith("modules", std::regex("drawFileWords\\(|drawDot\\(|drawTitle\\("));
  EXPECT_EQ(of_files.size(), 10u) << "a new one: is its picture shown in the window?";
  for (const auto& file : of_files) {
    const std::regex includes("pictures/" + fs::path(file).stem().string() + "\\.h\"");
    EXPECT_EQ(filesWith("ui", includes), Places{}) << file;
  }
  const std::regex makes(
      "\\b(drawPlan|drawSkinFit|drawFaceMeasures|drawSurfaceDistance|surfaceDistancePicture|burnPlan|"
      "titledRow|coilSliceSheet)\\(");
  EXPECT_GE(filesWith("modules", makes).size(), 10u) << "the search finds their makers";
  EXPECT_EQ(filesWith("ui", makes), Places{});
}

}  // namespace
}  // namespace facenav::testing
