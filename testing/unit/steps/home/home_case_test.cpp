#include "facenav/home/home_case.h"

#include <gmock/gmock.h>

#include <fstream>

#include "facenav/casefile/kept_session.h"
#include "facenav/casefile/sign_off.h"
#include "facenav/core/error.h"
#include "facenav/core/whole_file.h"
#include "facenav/core/zip_file.h"
#include "facenav/plan/expert_pose.h"
#include "support/ball_case.h"
#include "support/made_session.h"
#include "support/refusal.h"
#include "support/test_data.h"

namespace facenav::steps {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
namespace fs = std::filesystem;

const char* const kName = "Jane Doe";

class NoFace : public face::FaceDetector {
 public:
  std::optional<face::FaceLandmarks> detect(const cv::Mat&) const override { return std::nullopt; }
  std::optional<face::FaceLandmarks> detectNear(const cv::Mat&, const face::FaceLandmarks&) const override {
    return std::nullopt;
  }
  std::optional<face::FaceLandmarks> detectAtRoll(const cv::Mat&, double) const override {
    return std::nullopt;
  }
};

using facenav::testing::refusalOf;

/// Case without an MRI, with a session and the expert's pose of it.
class HomeCaseTest : public ::testing::Test {
 protected:
  HomeCaseTest()
      : store_(casefile::CaseStore::createFromFace(
            folder_.path() / "case", {testing::ballCase().scalp, {"no MRI"}, kName, {}}, {}, false)) {
    guidance::Target target;
    target.name = "M1";
    target.note = std::string(kName) + " likes it here";
    target.mri_T_target = {Eigen::Quaterniond(Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitX())), {0, 0, 94}};
    target.scalp_point = {0, 0, 90};
    target.cortex_point = {0, 0, 65};
    store_.setTargets({{target}});
    session_ = testing::writeMadeSession(store_.folder(), target);
    coil_.name = "figure-8 70 mm";
    writeCoil(coil_, folder_.path() / "coil.json");
  }
  HomeExport exportIt(const HomeOrder& order = {}) {
    TaskMonitor monitor;
    return exportHome(NoFace(), store_, order, file_, monitor);
  }
  HomeOrder withCoil() const {
    HomeOrder order;
    order.coil = (folder_.path() / "coil.json").string();
    return order;
  }
  void make() {
    storeExpertPose(store_, {});
    casefile::signOff(store_, {"XY", "", true});
    exportIt(withCoil());
  }
  testing::TemporaryFolder folder_;
  casefile::CaseStore store_;
  fs::path session_, file_ = folder_.path() / "home.zip", home_ = folder_.path() / "home";
  coil_tracking::CoilModel coil_ = coil_tracking::defaultCoil();
};

TEST_F(HomeCaseTest, ACaseWithoutAnMriSaysSoWhereAnMriIsNeeded) {
  EXPECT_FALSE(store_.hasMri());
  EXPECT_THAT(refusalOf([&] { store_.mri(); }), HasSubstr("holds no MRI"));
  EXPECT_THAT(refusalOf([&] { store_.headMask(); }), HasSubstr("holds no MRI"));
  EXPECT_FALSE(store_.brain());
  casefile::CaseStore::create(folder_.path() / "with", testing::ballCase(), {}, false);
  EXPECT_THAT(refusalOf([&] {
                casefile::CaseStore::createFromFace(folder_.path() / "with",
                                                    {testing::ballCase().scalp, {}, {}, {}}, {}, true);
              }),
              HasSubstr("has an MRI"));
}

TEST_F(HomeCaseTest, LeavesAsOneFileAndComesBackWithoutAName) {
  make();
  for (const auto& [name, content] : readZip(file_)) {
    EXPECT_THAT(content, Not(HasSubstr(kName))) << name;
    EXPECT_EQ(name.find("mri"), std::string::npos) << name;
  }
  const auto imported = importHome(file_, home_);
  EXPECT_EQ(imported.caseId(), store_.caseId()) << "what comes back can be told whose it is";
  EXPECT_EQ(imported.label(), "");
  const auto home = openHomeCase(home_);
  EXPECT_EQ(home.target.name, "expert M1");
  EXPECT_EQ(home.coil.name, "figure-8 70 mm");
  EXPECT_LT((home.target.mri_T_target.translation_mm() -
             store_.targets().find("expert M1").mri_T_target.translation_mm())
                .norm(),
            1e-6);
  EXPECT_EQ(imported.targets().targets.size(), 1u) << "the plan stays at the clinic";
}

TEST_F(HomeCaseTest, ANewerFileOfTheSameCaseKeepsItsSessions) {
  make();
  importHome(file_, home_);
  fs::create_directories(home_ / "sessions" / "20260101T000000Z");
  importHome(file_, home_);
  EXPECT_TRUE(fs::exists(home_ / "sessions" / "20260101T000000Z"));
  const auto other = casefile::CaseStore::createFromFace(folder_.path() / "other",
                                                         {testing::ballCase().scalp, {}, {}, {}}, {}, false);
  EXPECT_THAT(refusalOf([&] { importHome(file_, other.folder()); }), HasSubstr("another case"));
}

TEST_F(HomeCaseTest, AnOlderFileDoesNotReplaceANewerOne) {
  make();
  importHome(file_, home_);
  const auto madeOn = [&](const std::string& utc) {
    auto entries = readZip(file_);
    std::string& manifest = entries.at("home.json");
    manifest.replace(manifest.find(':', manifest.find("\"made_utc\"")) + 3, 24, utc);
    writeZip(entries, file_, FileAccess::owner_only);
  };
  madeOn("2001-02-03T04:05:06.789Z");
  EXPECT_THAT(refusalOf([&] { importHome(file_, home_); }),
              AllOf(HasSubstr("home.zip: it was made on 2001-02-03"), HasSubstr("choose the newest file")));
  madeOn("2101-02-03T04:05:06.789Z");
  EXPECT_EQ(refusalOf([&] { importHome(file_, home_); }), "");
  EXPECT_EQ(refusalOf([&] { importHome(file_, home_); }), "") << "the same file again";
  EXPECT_THAT(readWholeFile(home_ / "home.json"), HasSubstr("2101-02-03"));
  madeOn("some day in February....");
  EXPECT_THAT(refusalOf([&] { importHome(file_, home_); }), HasSubstr("made_utc"));
}

TEST_F(HomeCaseTest, NothingLeavesThatIsNotCheckedOrNotTheExperts) {
  EXPECT_THAT(refusalOf([&] { exportIt(withCoil()); }), HasSubstr("not signed off"));
  casefile::signOff(store_, {"XY", "", true});
  EXPECT_THAT(refusalOf([&] { exportIt(withCoil()); }), HasSubstr("no expert's pose"));
  storeExpertPose(store_, {});
  HomeOrder order = withCoil();
  order.target = "M1";
  EXPECT_THAT(refusalOf([&] { exportIt(order); }), HasSubstr("'M1' is no expert's pose"));
  order = {};
  order.coil_library = folder_.path() / "none";
  EXPECT_THAT(refusalOf([&] { exportIt(order); }), HasSubstr("not in the library"));
  coil_.name = "round";
  writeCoil(coil_, folder_.path() / "coil.json");
  EXPECT_THAT(refusalOf([&] { exportIt(withCoil()); }), HasSubstr("this is 'round'"));
  EXPECT_FALSE(fs::exists(file_));
}

TEST_F(HomeCaseTest, AChangedFileIsNotTaken) {
  make();
  auto entries = readZip(file_);
  std::string& targets = entries.at("targets.json");
  targets.replace(targets.find("\"expert M1\""), 11, "\"expert M2\"");
  writeZip(entries, file_, FileAccess::owner_only);
  EXPECT_THAT(refusalOf([&] { importHome(file_, home_); }), HasSubstr("'targets.json' in it has changed"));
  entries.erase("coil.json");
  writeZip(entries, file_, FileAccess::owner_only);
  EXPECT_NE(refusalOf([&] { importHome(file_, home_); }), "");
  writeWholeFile(file_, "no zip");
  EXPECT_NE(refusalOf([&] { importHome(file_, home_); }), "");
  EXPECT_FALSE(fs::exists(home_));
}

TEST_F(HomeCaseTest, AtHomeEachMissingPartIsNamed) {
  make();
  importHome(file_, home_);
  fs::remove(home_ / "coil.json");
  EXPECT_THAT(refusalOf([&] { openHomeCase(home_); }), HasSubstr("names no coil"));
  importHome(file_, home_);
  coil_.name = "round";
  writeCoil(coil_, home_ / "coil.json");
  EXPECT_THAT(refusalOf([&] { openHomeCase(home_); }), HasSubstr("this is 'round'"));
  importHome(file_, home_);
  fs::remove(home_ / "scalp.vtp");
  EXPECT_THAT(refusalOf([&] { openHomeCase(home_); }), HasSubstr("scalp.vtp"));
  importHome(file_, home_);
  std::ofstream(home_ / "scalp.vtp", std::ios::app) << "\n";
  EXPECT_THAT(refusalOf([&] { openHomeCase(home_); }), HasSubstr("not signed off"))
      << "the face was exchanged";
  fs::remove_all(home_);
  importHome(file_, home_);
  casefile::CaseStore::open(home_).setTargets({});
  EXPECT_THAT(refusalOf([&] { openHomeCase(home_); }), HasSubstr("no expert's pose"));
}

TEST_F(HomeCaseTest, TheFileToSendBackHoldsThePulsesAndNoName) {
  make();
  const auto sent = folder_.path() / "back.zip";
  writeSendBack(store_, session_, sent);
  const auto entries = readZip(sent);
  for (const char* name : {"report.html", "pulses.csv", "summary.json", "events.jsonl"})
    EXPECT_EQ(entries.count(name), 1u) << name;
  for (const auto& [name, content] : entries) EXPECT_THAT(content, Not(HasSubstr(kName))) << name;
  EXPECT_THAT(entries.at("summary.json"), HasSubstr(store_.caseId()));
  const auto& csv = entries.at("pulses.csv");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 41) << "a header and 40 pulses";
}

TEST_F(HomeCaseTest, TheFileToSendBackNamesNoFolderOfThisComputer) {
  std::ofstream(session_ / "pulses.jsonl", std::ios::app) << "{\"pulse\":99";  // cut short
  const auto sent = folder_.path() / "back.zip";
  writeSendBack(store_, session_, sent);
  const auto entries = readZip(sent);
  EXPECT_THAT(entries.at("summary.json"), AllOf(HasSubstr("\"pulses.jsonl, line"), HasSubstr("cut short")));
  for (const auto& [name, content] : entries)
    EXPECT_THAT(content, Not(HasSubstr(folder_.path().string()))) << name;
}

}  // namespace
}  // namespace facenav::steps
