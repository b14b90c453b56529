// The support bundle through the command line: names, places and passwords are planted everywhere that it
// reads, and none is in it.

#include <gmock/gmock.h>
#include <unistd.h>

#include <algorithm>
#include <array>

#include "facenav/core/whole_file.h"
#include "facenav/core/zip_file.h"
#include "support/ball_case.h"
#include "support/command_line.h"
#include "support/made_session.h"

namespace facenav::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

/// They are in lower case; each is planted in several places.
const std::vector<std::string> kPlanted{"quirrelmann",  "zaphod", "geheim77",     "praxis",
                                        "192.168.77.5", "4711xy", "beeblebrox",   "fordprefect",
                                        "heiligenberg", "müller", "ada lovelace", "fe80::77"};

const char* const kLog =
    "facenav: /home/fordprefect/Zaphod Quirrelmann 1970/mri.nii.gz: cannot be read; give another file\n"
    "warning: camera rtsp://doe:geheim77@cam9.praxis.lan/left: it does not answer: time-out after 3 s\n"
    "warning: camera at 192.168.77.5:554 went away; serial 4711XY\n"
    "cases/Zaphod Quirrelmann/alignment.json, key 'points': a number was expected\n"
    "the target 'Quirrelmann hand' lies outside the head\n"
    "mail to zaphod@praxis.lan; see https://praxis.lan/zaphod?token=geheim77\n"
    "frame 12: 3.5 mm off, 20 px/s; see 'facenav rig check'\n"
    "host fe80::77:1:2:3 of Dr. Beeblebrox and Frau Müller, ZAPHOD, overlay Ada Lovelace\n";

class SupportBundle : public ::testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(case_.parent_path());
    auto prepared = ballCase();
    prepared.label = "Zaphod Quirrelmann";
    prepared.findings = {"series 'Quirrelmann T1' of Heiligenberg"};
    const auto store = casefile::CaseStore::create(
        case_, prepared, {{"prepare", "0.1.0", {{"input", "/data/Quirrelmann"}, {"threads", "2"}}, {}}},
        false);
    guidance::Target target;
    target.name = "Quirrelmann hand";
    target.note = "asked for by Beeblebrox";
    target.cortex_point = Point<Mri>(0, 0, 60);
    target.scalp_point = Point<Mri>(0, 0, 90);
    target.mri_T_target = RigidTransform<Mri, frames::Target>(Eigen::Quaterniond(0, 1, 0, 0), {0, 0, 90});
    guidance::TreatmentPlan plan;
    plan.targets = {target};
    store.setTargets(plan);
    const auto session = writeMadeSession(case_, target, {});
    std::ofstream events(session / "events.jsonl", std::ios::app);
    events
        << R"({"utc":"2026-11-23T14:05:09.123Z","event":"operator","detail":"Dr Beeblebrox"})"
           "\n"
        << R"({"utc":"2026-11-23T14:05:10.123Z","event":"fault","detail":"/home/fordprefect/x y.csv: the disk is full; Beeblebrox"})"
           "\n"
        << R"({"utc":"2026-11-23T14:05:11.123Z","event":"Quirrelmann typed this","detail":"Zaphod"})"
           "\n";
    writeWholeFile(session / "notes.jsonl",
                   R"({"utc":"2026-11-23T14:06:09.123Z","event":"adverse event","detail":"Zaphod fainted"})"
                   "\n");
    writeWholeFile(case_ / "sign_off.json",
                   R"({"by": "Frau Müller", "utc": "x", "note": "Zaphod lay still"})");
    writeWholeFile(case_ / "overlays.json", R"({"overlays": [{"name": "Ada Lovelace", "kind": "map"}]})");
    writeWholeFile(case_ / "quirrelmann.stl", "solid zaphod");
    fs::create_directories(config_ / "facenav/rigs/Praxis Heiligenberg");
    writeWholeFile(config_ / "facenav/rigs/Praxis Heiligenberg/rig.json",
                   R"({"version": 1, "name": "Praxis Heiligenberg", "left": {"serial": "4711XY"}})");
    writeWholeFile(config_ / "facenav/stream_logins.json",
                   R"({"rtsp://doe@cam9.praxis.lan/left": "rtsp://doe:geheim77@cam9.praxis.lan/left"})");
    writeWholeFile(folder_.path() / "log.txt", kLog);
  }
  CommandResult run() const {
    return runProgram("env", "USER=fordprefect HOME=/home/fordprefect XDG_CONFIG_HOME='" + config_.string() +
                                 "' '" + FACENAV_CLI + "' support-bundle '" + case_.string() + "' --log '" +
                                 (folder_.path() / "log.txt").string() + "' -o '" + bundle_.string() + "'");
  }
  TemporaryFolder folder_;
  const fs::path case_ = folder_.path() / "Praxis Heiligenberg" / "Quirrelmann_Zaphod";
  const fs::path config_ = folder_.path() / "config", bundle_ = folder_.path() / "bundle.zip";
};

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  return text;
}

TEST_F(SupportBundle, HoldsNoNameThatWasPlantedAnywhere) {
  const auto result = run();
  ASSERT_EQ(result.status, 0) << result.errors;
  auto planted = kPlanted;
  std::array<char, 256> host{};
  ASSERT_EQ(::gethostname(host.data(), host.size() - 1), 0);
  if (std::string(host.data()).size() > 3) planted.push_back(lower(host.data()));
  for (const auto& [name, content] : readZip(bundle_))
    for (const auto& word : planted)
      EXPECT_EQ(lower(name + "\n" + content).find(word), std::string::npos) << word << " in " << name << ":\n"
                                                                            << content;
}

TEST_F(SupportBundle, HoldsWhatHelpsAndSaysWhatItIs) {
  const auto result = run();
  ASSERT_EQ(result.status, 0) << result.errors;
  const auto entries = readZip(bundle_);
  for (const char* name :
       {"README.txt", "case.json", "log.txt", "machine.json", "program.json", "rigs.json"}) {
    ASSERT_TRUE(entries.count(name)) << name;
    EXPECT_THAT(result.output, HasSubstr(name));
  }
  EXPECT_THAT(entries.at("program.json"), HasSubstr("commit"));
  EXPECT_THAT(entries.at("machine.json"), HasSubstr("\"kernel\""));
  for (const char* words : {"\"schema_version\": 1", "mri.nii.gz", "[other].stl", "\"threads\": \"2\"",
                            "no_face", "session started", "the disk is full", "[other]"})
    EXPECT_THAT(entries.at("case.json"), HasSubstr(words));
  for (const char* words :
       {"cannot be read; give another file", "time-out after 3 s", "went away",
        "frame 12: 3.5 mm off, 20 px/s; see 'facenav rig check'", "a number was expected"})
    EXPECT_THAT(entries.at("log.txt"), HasSubstr(words));
}

TEST_F(SupportBundle, RefusesACaseThatIsNotThere) {
  const auto result = runFacenav("support-bundle /none -o '" + bundle_.string() + "'");
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.errors, HasSubstr("no such case folder"));
  EXPECT_FALSE(fs::exists(bundle_));
}

}  // namespace
}  // namespace facenav::testing
