// Wrong input to each verb: one clear line on stderr, exit status 1 (2 for wrong usage), no partly written
// output.

#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "support/ball_case.h"
#include "support/command_line.h"
#include "support/wrong_usage.h"

namespace facenav::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

void writeText(const fs::path& path, const std::string& text) { std::ofstream(path) << text; }

/// Expects status 1, exactly one line that names the problem, and no `product`.
void expectRefused(const CommandResult& result, const std::string& named, const fs::path& product = {}) {
  EXPECT_EQ(result.status, 1) << result.errors;
  EXPECT_EQ(std::count(result.errors.begin(), result.errors.end(), '\n'), 1) << result.errors;
  EXPECT_THAT(result.errors, HasSubstr("facenav: "));
  EXPECT_THAT(result.errors, HasSubstr(named));
  if (!product.empty()) {
    EXPECT_FALSE(fs::exists(product)) << product;
  }
}

class CommandLine : public ::testing::Test {
 protected:
  fs::path at(const std::string& name) const { return folder_.path() / name; }
  bool isClean() const {  // no temporary files are left
    return std::none_of(
        fs::directory_iterator(folder_.path()), fs::directory_iterator(),
        [](const auto& entry) { return entry.path().filename().string().find("tmp") != std::string::npos; });
  }
  TemporaryFolder folder_;
};

TEST_F(CommandLine, UnknownVerbIsWrongUsage) {
  const auto result = runFacenav("frobnicate");
  EXPECT_EQ(result.status, 2);
  EXPECT_THAT(result.errors, HasSubstr("--help"));
}

TEST_F(CommandLine, MissingArgumentIsWrongUsage) { EXPECT_EQ(runFacenav("prepare").status, 2); }

TEST_F(CommandLine, HelpHoldsEveryVerb) {
  const auto all = runFacenav("help --all");
  EXPECT_EQ(all.status, 0) << all.errors;
  for (const char* verb : {"series",    "pacs find", "prepare",
                           "check",     "brain",     "worklist",
                           "label",     "locate",    "target",
                           "plan",      "field",     "threshold",
                           "hotspot",   "note",      "export",
                           "cameras",   "calibrate", "rig new",
                           "rig check", "record",    "marker",
                           "coil add",  "align",     "cloud",
                           "track",     "guide",     "projector calibrate",
                           "sessions",  "pulses",    "report",
                           "face-case", "import",    "calibrate-coil",
                           "simulate",  "evaluate",  "evaluate prepare",
                           "settings",  "demo",      "serve"})
    EXPECT_THAT(all.output, HasSubstr("Usage: facenav " + std::string(verb) + " ")) << verb;
}

TEST_F(CommandLine, HelpVerbIsTheVerbsHelp) {
  for (const char* verb : {"prepare", "rig new"}) {
    const auto by_option = runFacenav(std::string(verb) + " --help"),
               by_verb = runFacenav("help " + std::string(verb));
    EXPECT_EQ(by_option.status, 0);
    EXPECT_EQ(by_verb.status, 0);
    EXPECT_EQ(by_verb.output, by_option.output);
    EXPECT_THAT(by_verb.output, HasSubstr("Usage: facenav " + std::string(verb)));
  }
  EXPECT_EQ(runFacenav("help").output, runFacenav("--help").output);
}

TEST_F(CommandLine, HelpListsTheVerbsByStep) {
  const std::string help = runFacenav("--help").output;
  std::size_t before = 0;
  for (const char* line :
       {"\nPrepare:\n", "\n  prepare ", "\nPlan:\n", "\n  target ", "\nSet up:\n", "\n  rig ", "\nAlign:\n",
        "\n  align ", "\nTreat:\n", "\n  track ", "\nReview:\n", "\n  report ", "\nHome:\n", "\n  import ",
        "\nLab and others:\n", "\n  settings "}) {
    const std::size_t at = help.find(line, before);
    ASSERT_NE(at, std::string::npos) << line;
    before = at;
  }
}

TEST_F(CommandLine, NoLineOfAnyHelpIsLongerThan80) {
  for (const char* words : {"help --all", "--help"}) {
    std::istringstream help(runFacenav(words).output);
    int lines = 0;
    for (std::string line; std::getline(help, line); ++lines) EXPECT_LE(line.size(), 80u) << line;
    EXPECT_GT(lines, 50) << words;
  }
}

TEST_F(CommandLine, MistypedVerbIsToldTheNearest) {
  for (const auto& [typed, told] : std::vector<std::pair<std::string, std::string>>{
           {"prepar x -o y", "no verb 'prepar'; did you mean 'prepare'? (see 'facenav --help')"},
           {"aling --help", "no verb 'aling'; did you mean 'align'? (see 'facenav --help')"},
           {"help trak", "no verb 'trak'; did you mean 'track'? (see 'facenav --help')"},
           {"rig nwe", "rig has no verb 'nwe'; did you mean 'new'? (see 'facenav rig --help')"},
           {"frobnicate", "no verb 'frobnicate' (see 'facenav --help')"}}) {
    const auto result = runFacenav(typed);
    EXPECT_EQ(result.status, 2) << typed;
    EXPECT_EQ(result.errors, "facenav: " + told + "\n");
    EXPECT_EQ(result.output, "");
  }
}

TEST_F(CommandLine, VersionNamesTheCommit) {
  const auto result = runFacenav("--version");
  EXPECT_EQ(result.status, 0);
  EXPECT_THAT(result.output,
              ::testing::MatchesRegex("[0-9]+\\.[0-9]+\\.[0-9]+ \\(commit ([0-9a-f]+|unknown)\\)\n"));
}

TEST_F(CommandLine, SeriesOfAMissingFolder) {
  expectRefused(runFacenav("series " + at("none").string()), "none");
}

TEST_F(CommandLine, SeriesOfAFolderWithoutDicom) {
  writeText(at("a.txt"), "no DICOM");
  expectRefused(runFacenav("series " + folder_.path().string()), folder_.path().filename().string());
}

TEST_F(CommandLine, PacsThatDoesNotAnswer) {
  expectRefused(runFacenav("pacs echo --host 127.0.0.1 --port 1 --title NOBODY"), "does not answer");
  expectRefused(
      runFacenav("pacs get --host 127.0.0.1 --port 1 --title NOBODY --study 1.2 --series 1.2.3 -o " +
                 at("in").string()),
      "127.0.0.1:1", at("in"));
  EXPECT_TRUE(isClean());
}

TEST_F(CommandLine, PrepareOfAMissingFile) {
  expectRefused(runFacenav("prepare " + at("none.nii.gz").string() + " -o " + at("case").string()),
                "none.nii.gz", at("case"));
}

TEST_F(CommandLine, PrepareOfATruncatedNifti) {
  FACENAV_NEEDS(colin27());
  const std::string whole = readText(colin27());
  writeText(at("cut.nii.gz"), whole.substr(0, whole.size() / 3));
  expectRefused(runFacenav("prepare " + at("cut.nii.gz").string() + " -o " + at("case").string()),
                "cut.nii.gz", at("case"));
  EXPECT_TRUE(isClean());
}

TEST_F(CommandLine, PrepareOfAFileThatIsNoVolume) {
  writeText(at("a.nii"), "not a volume");
  expectRefused(runFacenav("prepare " + at("a.nii").string() + " -o " + at("case").string()), "a.nii",
                at("case"));
}

TEST_F(CommandLine, PrepareIntoAFolderThatIsNotThereIsSaidBeforeTheWork) {
  writeText(at("a.nii"), "not a volume");
  expectRefused(runFacenav("prepare " + at("a.nii").string() + " -o " + at("none/case").string()),
                "no such folder to make the case in", at("none"));
}

TEST_F(CommandLine, CheckExportAndWorklistOfWhatIsNotThere) {
  expectRefused(runFacenav("check " + at("none").string() + " --by A.R."), "none");
  expectRefused(runFacenav("export " + at("none").string() + " --as stl -o " + at("out").string()), "none",
                at("out"));
  expectRefused(runFacenav("worklist " + at("none").string()), "none");
  expectRefused(runFacenav("label " + at("none").string() + " words"), "none");
  expectRefused(runFacenav("locate " + at("none").string() + " --mni 0 0 0"), "none");
  expectRefused(runFacenav("target " + at("none").string() + " --name M1 --ras 0 0 0"), "none");
}

TEST_F(CommandLine, BrainOfWhatIsNotThereOrIsNoPlace) {
  expectRefused(runFacenav("brain " + at("none").string()), "none");
  for (const char* words : {"1,2,3", "1,2,3,x", "1,2,3,0", "1,2,3,4,5"})
    expectWrongUsage("brain " + at("none").string() + " --add-sphere " + words, "RADIUS");
  expectWrongUsage("brain " + at("none").string() + " --add-sphere ''", "the text is empty");
  expectWrongUsage("brain " + at("none").string() + " --grow 1,2", "R,A,S");
}

TEST_F(CommandLine, BrainIsCorrectedAndTheCorrectionTakenBack) {
  casefile::CaseStore::create(at("case"), ballWithBrain(), {}, false);
  const std::string brain = "brain " + at("case").string();
  const auto store = casefile::CaseStore::open(at("case"));
  const auto prepared = store.brainMask()->voxels;
  EXPECT_THAT(runFacenav(brain).output, HasSubstr("as prepared"));
  const auto result =
      runFacenav(brain + " --add-sphere -42,2,2,10 --add-sphere 42,2,2,10 --remove-sphere=2,2,2,6");
  EXPECT_EQ(result.status, 0) << result.errors;
  EXPECT_THAT(result.output, HasSubstr("must be checked again"));
  EXPECT_NE(store.brainMask()->voxels, prepared);
  EXPECT_THAT(runFacenav(brain).output, HasSubstr("corrected by hand"));
  EXPECT_EQ(runFacenav(brain + " --automatic").status, 0);
  EXPECT_EQ(store.brainMask()->voxels, prepared);
  EXPECT_TRUE(isClean());
}

TEST_F(CommandLine, CalibrateWithoutImages) {
  expectRefused(runFacenav("calibrate --board 9x6 --square 25 --left '" + at("left*.jpg").string() +
                           "' --right '" + at("right*.jpg").string() + "' -o " + at("stereo.yml").string()),
                "left*.jpg", at("stereo.yml"));
}

TEST_F(CommandLine, TrackOfAMissingRecording) {
  expectRefused(runFacenav("track " + at("none").string() + " -o " + at("poses.csv").string()), "none",
                at("poses.csv"));
}

TEST_F(CommandLine, CloudOfAMissingRecording) {
  expectRefused(runFacenav("cloud " + at("none").string() + " -o " + at("face.ply").string()), "none",
                at("face.ply"));
}

TEST_F(CommandLine, CloudOfWhatIsNoRangeOfFrames) {
  for (const char* range : {"5", "5..", "..5", "9..5", "a..b"}) {
    const auto result =
        runFacenav("cloud " + at("none").string() + " --frames " + range + " -o " + at("face.ply").string());
    EXPECT_EQ(result.status, 2) << range;
    EXPECT_THAT(result.errors, HasSubstr("N..M")) << range;
  }
}

TEST_F(CommandLine, TrackOfARigWithoutT) {
  fs::create_directories(at("rec/left"));
  fs::create_directories(at("rec/right"));
  writeText(at("rec/stereo.yml"),
            "%YAML:1.0\n---\nimage_width: 640\nimage_height: 480\nK1: !!opencv-matrix\n   rows: 3\n   cols: "
            "3\n   dt: d\n"
            "   data: [ 800., 0., 320., 0., 800., 240., 0., 0., 1. ]\n");
  const auto result = runFacenav("track " + at("rec").string() + " -o " + at("poses.csv").string());
  expectRefused(result, "stereo.yml", at("poses.csv"));
  EXPECT_THAT(result.errors, HasSubstr("resources/doc/formats.md"));
}

TEST_F(CommandLine, GuideOfAFolderThatIsNoCase) {
  writeText(at("poses.csv"), "frame,t_s,object,status,tx,ty,tz,qw,qx,qy,qz,quality,reason\n");
  expectRefused(runFacenav("guide " + folder_.path().string() + " " + at("poses.csv").string() +
                           " --target X -o " + at("guidance.csv").string()),
                "case.json", at("guidance.csv"));
}

TEST_F(CommandLine, AFileWithoutARequiredKeyNamesThePageOfFormats) {
  writeText(at("coil.json"), R"({"name": "figure-8"})");
  const auto result =
      runFacenav("marker --coil " + at("coil.json").string() + " -o " + at("marker.svg").string());
  expectRefused(result, "key 'marker'", at("marker.svg"));
  EXPECT_THAT(result.errors, HasSubstr("see resources/doc/formats.md"));
}

TEST_F(CommandLine, ATableWithoutARequiredColumnNamesThePageOfFormats) {
  casefile::CaseStore::create(at("case"), ballWithBrain(), {}, false);
  writeText(at("poses.csv"), "frame,t_s,object\n");
  const auto result = runFacenav("guide " + at("case").string() + " " + at("poses.csv").string() +
                                 " --target X -o " + at("guidance.csv").string());
  expectRefused(result, "poses.csv, line 1", at("guidance.csv"));
  EXPECT_THAT(result.errors, HasSubstr("see resources/doc/formats.md"));
}

TEST_F(CommandLine, AlignOfAMissingCase) {
  expectRefused(runFacenav("align " + at("none").string() + " " + at("rec").string()), "none");
}

TEST_F(CommandLine, SimulateOfAnUnknownScenarioListsTheKnown) {
  expectWrongUsage("simulate nonsense -o " + at("rec").string(), "treatment");
  EXPECT_FALSE(fs::exists(at("rec")));
}

}  // namespace
}  // namespace facenav::testing
