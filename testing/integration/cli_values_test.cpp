// What is typed and what is written: numbers, names and options that are refused before any work, files for
// their owner alone, standard output, and what verbs tell.

#include <fstream>

#include "support/ball_case.h"
#include "support/wrong_usage.h"

namespace facenav::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

constexpr fs::perms kOwnerOnly = fs::perms::owner_read | fs::perms::owner_write;

fs::perms modeOf(const fs::path& path) { return fs::status(path).permissions(); }
void writeText(const fs::path& path, const std::string& text) { std::ofstream(path) << text; }

class CommandValues : public ::testing::Test {
 protected:
  fs::path at(const std::string& name) const { return folder_.path() / name; }
  TemporaryFolder folder_;
};

TEST_F(CommandValues, NumbersThatAreNoneAreRefusedWhereTheyAreTyped) {
  const std::string c = at("none").string();
  const std::vector<std::pair<std::string, std::string>> all{
      // words with # in the number's place, and what the refusal names
      {"locate " + c + " --mni # 1 2", "--mni"},
      {"locate " + c + " --ras 1 2 #", "--ras"},
      {"target " + c + " --name M1 --mni 1 # 2", "--mni"},
      {"target " + c + " --name M1 --ras 1 1 2 --handle-deg #", "--handle-deg"},
      {"plan " + c + " --preset m1-hand-left --handle-deg #", "--handle-deg"},
      {"plan " + c + " --preset m1-hand-left --gap-mm #", "--gap-mm"},
      {"plan " + c + " --set-landmark nasion=1,2,#", "landmark"},
      {"brain " + c + " --grow 1,2,#", "R,A,S"},
      {"pulses " + c + " --set-mep 1=#", "MEP"},
      {"pulses " + c + " --offset #", "--offset"},
      {"marker --size # -o " + at("m.svg").string(), "--size"},
      {"track x -o y --intensity # --pulses keyboard", "--intensity"},
      {"simulate still -o " + at("rec").string() + " --noise-grey #", "--noise-grey"}};
  const auto refuses = [&](const auto& typed, const std::string& number) {
    std::string words = typed.first;
    expectWrongUsage(words.replace(words.find('#'), 1, number), typed.second);
  };
  const std::vector<std::string> numbers{"nan", "inf", "1e30", "NaN", "-inf", "1e999", "0x10"};
  for (const auto& number : numbers) refuses(all.front(), number);
  for (std::size_t i = 1; i < all.size(); ++i) {  // the readers of numbers are shared: two each are enough
    refuses(all[i], "nan");
    refuses(all[i], numbers[1 + i % (numbers.size() - 1)]);
  }
}

TEST_F(CommandValues, ADecimalCommaAndANumberOutOfRangeAreSaidPlainly) {
  const std::string c = at("none").string();
  expectWrongUsage("target " + c + " --ras 1 2 3 --name M1 --gap-mm 3,5", "write 3.5");
  expectWrongUsage("target " + c + " --ras 1 2 3 --name M1 --gap-mm 21", "not in range 0 to 20 (see");
}

TEST_F(CommandValues, AnEmptyTextIsRefused) {
  const std::string c = at("none").string();
  for (const char* words :
       {"check CASE --by ''", "plan CASE --preset m1-hand-left --name ''", "plan ''", "report CASE -o ''",
        "target CASE --from-session ''", "cameras --try 1 --left ''"}) {
    std::string typed = words;
    if (const auto at = typed.find("CASE"); at != std::string::npos) typed.replace(at, 4, c);
    expectWrongUsage(typed, "the text is empty");
  }
}

TEST_F(CommandValues, AnOptionThatWouldDoNothingIsWrongUsage) {
  const std::string c = at("none").string(), o = " -o " + at("out").string();
  for (const auto& [words, named] : std::vector<std::pair<std::string, std::string>>{
           {"plan " + c + " --name M1", "--name does nothing here; give it with --preset or --peak"},
           {"plan " + c + " --gap-mm 2", "--gap-mm does nothing here"},
           {"plan " + c + " --target M1", "--target does nothing here"},
           {"plan " + c + " --target M1 --spacing-mm 5", "give it with --grid"},
           {"plan " + c + " --threshold 3", "give it with --overlay or --overlay-name"},
           {"plan " + c + " --target M1 --lock --unlock", "excludes"},
           {"plan " + c + " --target M1 --grid 3 3 --no-grid", "excludes"},
           {"target " + c + " --from-session newest --ras 1 2 3", "excludes"},
           {"field " + c + " --target M1 --coil round --arrows", "requires --json"},
           {"track x" + o + " --intensity 50", "give it with --pulses, --live or --tracker-head"},
           {"track x" + o + " --commands", "--commands does nothing here"},
           {"track x" + o + " --serve",
            "--serve does nothing here; give it with --pulses, --live or --tracker-head"},
           {"track x" + o + " --send osc:9", "--send does nothing here"},
           {"guide " + c + " x --target M1" + o + " --pulses keyboard",
            "--pulses does nothing here; give it with --live"},
           {"pulses " + c + " --reason moved", "give it with --exclude or --include"},
           {"pulses " + c + " --exclude 3 --include 3 --reason moved", "pulse 3 is excluded and included"},
           {"cameras --left rtsp://doe:secret@host", "give it with --try or --latency"},
           {"export " + c + o + " --as stl --target M1", "give it with --as home"}})
    expectWrongUsage(words, named);
}

TEST_F(CommandValues, NamesOfFormatsAndPicturesAreCheckedBeforeTheWork) {
  const std::string c = at("none").string(), o = " -o " + at("out").string();
  expectWrongUsage("export " + c + " --as foo" + o, "unknown export format 'foo'");
  expectWrongUsage("export " + c + " --as home --as stl" + o, "'home' is one file");
  expectWrongUsage("plan " + c + " --picture " + at("a.jpg").string(), "write .png");
  expectWrongUsage("report " + c + " -o " + at("a.pdf").string(), "write .html");
  expectWrongUsage("report " + c + " --pdf-file " + at("a.txt").string(), "write .pdf");
  casefile::CaseStore::create(at("case"), ballCase(), {}, false);
  EXPECT_EQ(runFacenav("export " + at("case").string() + " --as stl --as stl" + o).status, 0)
      << "a format that is named twice is written once";
  const auto folder = runFacenav("plan " + at("case").string() + " --overlay " + at("case").string());
  EXPECT_EQ(folder.status, 1);
  EXPECT_THAT(folder.errors, HasSubstr("is a folder, a file was expected"));
}

TEST_F(CommandValues, NamesWithControlCharactersAndEndlessOnesAreRefused) {
  const std::string c = at("none").string();
  expectWrongUsage("target " + c + " --ras 1 2 3 --name 'a\x1b[2Jb'", "control character");
  expectWrongUsage("target " + c + " --ras 1 2 3 --name 'a\nb'", "control character");
  expectWrongUsage("plan " + c + " --preset m1-hand-left --name '\xff'", "UTF-8");
  expectWrongUsage("label " + c + " " + std::string(5000, 'x'), "longer");
  expectWrongUsage("check " + c + " --by 'A\x07'", "control character");
}

TEST_F(CommandValues, OptionsThatDoNotGoTogetherAreWrongUsage) {
  const std::string c = at("none").string(), o = " -o " + at("out").string();
  for (const auto& [words, named] : std::vector<std::pair<std::string, std::string>>{
           {"locate " + c, "no place"},
           {"target " + c + " --name M1", "no place"},
           {"target " + c + " --ras 1 2 3", "--name"},
           {"plan", "CASE"},
           {"plan " + c + " --preset nonsense", "beam-f3"},
           {"plan " + c + " --find-landmark chin", "nasion"},
           {"check " + c + " --note words", "--by"},
           {"align " + c, "RECORDING"},
           {"align " + c + " r --aligner nonsense", "aligner"},
           {"align " + c + " r --matcher nonsense", "matcher"},
           {"track" + o, "RECORDING"},
           {"track r --head-tracker nonsense" + o, "head tracker"},
           {"guide " + c + " --target M1" + o, "POSES"},
           {"prepare x --brain nonsense" + o, "brain segmentation"},
           {"calibrate-coil" + o, "--jig"},
           {"settings nonsense", "module"},
           {"settings --why nonsense", "evidence"},
           {"record" + o, "--rig"},
           {"cameras --try 1", "--left"},
           {"report " + c + " -o - --pdf", "--pdf-file"},
           {"evaluate --scenario nonsense" + o, "scenario"},
           {"evaluate --head patient:nonsense" + o, "variant"},
           {"evaluate --head nowhere" + o, "head"},
           {"simulate still --rig nonsense" + o, "rig"}})
    expectWrongUsage(words, named);
  EXPECT_FALSE(fs::exists(at("out")));
}

TEST_F(CommandValues, OutputGoesToAFileOrToStandardOutputNeverOverADevice) {
  const auto page = runFacenav("marker -o -");
  EXPECT_EQ(page.status, 0) << page.errors;
  EXPECT_EQ(page.output.rfind("<?xml", 0) == 0 || page.output.rfind("<svg", 0) == 0, true)
      << page.output.substr(0, 60);
  EXPECT_THAT(page.output, ::testing::Not(HasSubstr("then check"))) << "words go to standard error";
  EXPECT_THAT(page.errors, HasSubstr("then check"));
  fs::create_symlink("/dev/null", at("link"));
  for (const std::string& place : {std::string("/dev/null"), at("link").string()})
    expectWrongUsage("marker -o " + place, "not replaced");
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  expectWrongUsage("prepare x -o -", "standard output");
  const auto device = runFacenav("marker -o /dev/stdout");  // here a file, but named by the system
  EXPECT_EQ(device.status, 1);
  EXPECT_THAT(device.errors, HasSubstr("standard output"));
}

TEST_F(CommandValues, WhatIsWrittenAboutAPatientIsForItsOwnerAlone) {
  casefile::CaseStore::create(at("case"), ballWithBrain(), {}, false);
  const std::string c = at("case").string();
  EXPECT_EQ(runFacenav("target " + c + " --name M1 --ras 0 0 35").status, 0);
  EXPECT_EQ(runFacenav("plan " + c + " --picture " + at("p.png").string()).status, 0);
  EXPECT_EQ(modeOf(at("p.png")), kOwnerOnly);
  EXPECT_EQ(runFacenav("plan " + c + " --slices " + at("s.png").string()).status, 0);
  EXPECT_EQ(modeOf(at("s.png")), kOwnerOnly);
  for (const auto& entry : fs::recursive_directory_iterator(at("case"))) {
    if (!entry.is_regular_file()) continue;
    EXPECT_EQ(modeOf(entry.path()), kOwnerOnly) << entry.path();
  }
}

TEST_F(CommandValues, AddingATargetTellsThatTargetAndADamagedOneCostsNoOther) {
  casefile::CaseStore::create(at("case"), ballWithBrain(), {}, false);
  const std::string c = at("case").string();
  const auto first = runFacenav("target " + c + " --name first --ras 0 0 35 --json");
  EXPECT_EQ(first.status, 0) << first.errors;
  EXPECT_THAT(first.output, HasSubstr("\"name\": \"first\""));
  const auto second = runFacenav("plan " + c + " --target first --duplicate");
  EXPECT_THAT(second.output, HasSubstr("first copy"));
  EXPECT_EQ(std::count(second.output.begin(), second.output.end(), '\n'), 1) << second.output;
  std::string plan = readText(at("case/targets.json"));
  const auto second_pose = plan.rfind("\"mri_T_target\"");
  plan.replace(plan.find("1", second_pose), 1, "NaN");
  writeText(at("case/targets.json"), plan);
  const auto left = runFacenav("plan " + c);
  EXPECT_EQ(left.status, 0) << left.errors;
  EXPECT_THAT(left.output, HasSubstr("first "));
  EXPECT_THAT(left.errors, HasSubstr("a target is left out"));
  EXPECT_EQ(runFacenav("plan " + c + " --target first --note repaired").status, 0);
  EXPECT_EQ(runFacenav("plan " + c).errors, "");
  EXPECT_TRUE(fs::exists(at("case/targets_damaged.json")));
}

TEST_F(CommandValues, CheckSaysByWhomAndWhenItWasSigned) {
  casefile::CaseStore::create(at("case"), ballWithBrain(), {}, false);
  const std::string check = "check " + at("case").string();
  EXPECT_THAT(runFacenav(check).output, HasSubstr("not signed off"));
  EXPECT_EQ(runFacenav(check + " --by A.R. --acknowledge-findings --note 'as seen'").status, 0);
  const std::string now = runFacenav(check).output;
  EXPECT_THAT(now, HasSubstr("signed off by A.R. at 2"));
  EXPECT_THAT(now, HasSubstr("as seen"));
  const std::string json = runFacenav(check + " --json").output;
  EXPECT_THAT(json, HasSubstr("\"by\": \"A.R.\""));
  EXPECT_THAT(json, HasSubstr("\"holds\": true"));
  EXPECT_EQ(runFacenav("brain " + at("case").string() + " --remove-sphere 2,2,2,6").status, 0);
  EXPECT_THAT(runFacenav(check).output, HasSubstr("void, changed since: brain"));
  EXPECT_EQ(runFacenav(check + " --by B.C. --reject blurred").status, 0);
  EXPECT_THAT(runFacenav(check).output, HasSubstr("rejected by B.C. at 2"));
  EXPECT_THAT(runFacenav(check + " --json").output, HasSubstr("\"reason\": \"blurred\""));
}

TEST_F(CommandValues, VerbsThatListOrReportTakeJson) {
  EXPECT_EQ(runFacenav("help --man-pages " + at("pages").string()).status, 0);
  for (const char* verb :
       {"series",    "pacs-find", "check",   "brain",     "worklist",       "label",     "locate",
        "target",    "plan",      "cameras", "calibrate", "calibrate-coil", "rig-list",  "rig-check",
        "coil-list", "coil-show", "align",   "track",     "guide",          "threshold", "sessions",
        "pulses",    "hotspot",   "import",  "settings",  "serve"})
    EXPECT_THAT(readText(at("pages") / ("facenav-" + std::string(verb) + ".1")), HasSubstr("\\-\\-json"))
        << verb;
}

TEST_F(CommandValues, TheProtocolTemplateIsAFileToChange) {
  const auto made = runFacenav("plan --protocol-template -");
  EXPECT_EQ(made.status, 0) << made.errors;
  for (const char* key : {"name", "version", "pulses", "trains", "frequency_hz", "pause_s", "output_pct",
                          "threshold_pct", "sessions", "note"})
    EXPECT_THAT(made.output, HasSubstr("\"" + std::string(key) + "\"")) << key;
}

TEST_F(CommandValues, CompletionKnowsVerbsOptionsAndValues) {
  const auto script = runFacenav("help --completion bash");
  EXPECT_EQ(script.status, 0) << script.errors;
  writeText(at("complete"), script.output);
  const auto complete = [&](const std::string& words, int current) {
    return runProgram("/bin/bash", "-c 'source " + at("complete").string() + "; COMP_WORDS=(" + words +
                                       "); COMP_CWORD=" + std::to_string(current) +
                                       "; _facenav; echo \"${COMPREPLY[@]}\"'")
        .output;
  };
  EXPECT_EQ(complete("facenav wor", 1), "worklist\n");
  EXPECT_EQ(complete("facenav rig n", 2), "new\n");
  EXPECT_EQ(complete("facenav plan case --protocol-t", 3), "--protocol-template\n");
  EXPECT_EQ(complete("facenav plan case --on sc", 4), "scalp\n");
  EXPECT_EQ(complete("facenav check some", 2), "\n") << "files are left to the shell";
  const auto zsh = runFacenav("help --completion zsh");
  EXPECT_THAT(zsh.output, ::testing::StartsWith("#compdef facenav\n"));
  EXPECT_THAT(zsh.output, HasSubstr("'worklist:"));
}

TEST_F(CommandValues, EachVerbHasAManPage) {
  EXPECT_EQ(runFacenav("help --man-pages " + at("man1").string()).status, 0);
  for (const char* page : {"facenav.1", "facenav-plan.1", "facenav-rig-new.1"})
    EXPECT_TRUE(fs::exists(at("man1") / page)) << page;
  const std::string plan = readText(at("man1/facenav-plan.1"));
  EXPECT_THAT(plan, HasSubstr(".SH SYNOPSIS\n.B facenav plan"));
  EXPECT_THAT(plan, HasSubstr("\\-\\-protocol\\-template"));
}

}  // namespace
}  // namespace facenav::testing
