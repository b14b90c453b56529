#include "facenav/home/returned_session.h"

#include <gmock/gmock.h>

#include <fstream>

#include "facenav/casefile/kept_session.h"
#include "facenav/core/whole_file.h"
#include "facenav/core/zip_file.h"
#include "facenav/home/home_case.h"
#include "facenav/report/session_report.h"
#include "facenav/report/session_review.h"
#include "support/ball_case.h"
#include "support/made_session.h"
#include "support/refusal.h"
#include "support/test_data.h"

namespace facenav::steps {
namespace {

using facenav::testing::refusalOf;
using ::testing::HasSubstr;
namespace fs = std::filesystem;

/// One person's case at the clinic and at home, and a session at home.
class ReturnedSessionTest : public ::testing::Test {
 protected:
  ReturnedSessionTest()
      : clinic_(casefile::CaseStore::createFromFace(
            folder_.path() / "clinic", {testing::ballCase().scalp, {}, "Jane Doe", {}}, {}, false)),
        home_(casefile::CaseStore::createFromFace(
            folder_.path() / "home", {testing::ballCase().scalp, {}, "", clinic_.caseId()}, {}, false)) {
    target_.name = "M1";
    target_.mri_T_target = {Eigen::Quaterniond(Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitX())),
                            {0, 0, 94}};
    target_.cortex_point = {0, 0, 65};
    session_ = testing::writeMadeSession(home_.folder(), target_);
    casefile::addNote(session_, "at home", "three steps, big buttons");
    writeSendBack(home_, session_, file_);
  }
  /// Reads every file of the clinic's case with its content.
  std::map<std::string, std::string> everything() const {
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(clinic_.folder()))
      files[entry.path().string()] = entry.is_regular_file() ? readWholeFile(entry.path()) : "";
    return files;
  }
  /// Changes one entry of the file.
  void change(const std::string& name, const std::function<void(std::string&)>& edit) {
    auto entries = readZip(file_);
    edit(entries.at(name));
    writeZip(entries, file_);
  }
  testing::TemporaryFolder folder_;
  casefile::CaseStore clinic_, home_;
  guidance::Target target_;
  fs::path session_, file_ = folder_.path() / "back.zip";
};

TEST_F(ReturnedSessionTest, BecomesASessionOfTheCaseMarkedAsOneAtHome) {
  ASSERT_TRUE(isReturnedFile(file_));
  EXPECT_FALSE(isHomeFile(file_));
  const auto returned = importReturned(clinic_, file_);
  EXPECT_EQ(returned.outcome, ReturnedOutcome::added);
  EXPECT_EQ(returned.folder, clinic_.folder() / "sessions" / session_.filename());
  const auto there = casefile::readSession(session_), here = casefile::readSession(returned.folder);
  ASSERT_EQ(here.pulses.pulses.size(), 40u);
  EXPECT_EQ(casefile::pulsesCsv(here.pulses.pulses), casefile::pulsesCsv(there.pulses.pulses));
  const auto at_home = report::summarise(there);
  const auto summary = report::summariseSessions(clinic_.folder()).at(0);
  EXPECT_TRUE(summary.is_at_home);
  EXPECT_EQ(summary.on_target, at_home.on_target);
  EXPECT_EQ(summary.lost, at_home.lost);
  EXPECT_NEAR(summary.duration_s.value(), at_home.duration_s.value(), 1e-9);
  EXPECT_NEAR(summary.off_target_s.value(), at_home.off_target_s.value(), 1e-9);
  EXPECT_TRUE(summary.problems.empty());
  EXPECT_THAT(report::sessionReport(clinic_, here), HasSubstr("at home; the file came back on"));
  EXPECT_EQ(fs::status(returned.folder / "pulses.jsonl").permissions() & fs::perms::others_all,
            fs::perms::none);
}

TEST_F(ReturnedSessionTest, ASecondImportChangesNothing) {
  importReturned(clinic_, file_);
  const auto before = everything();
  EXPECT_EQ(importReturned(clinic_, file_).outcome, ReturnedOutcome::unchanged);
  EXPECT_TRUE(everything() == before);
  EXPECT_EQ(importReturned(home_, file_).outcome, ReturnedOutcome::unchanged) << "where it was made";
}

TEST_F(ReturnedSessionTest, ALaterFileAddsWhatWasNotedSinceAndKeepsTheClinicsEdits) {
  const auto first = importReturned(clinic_, file_);
  casefile::editPulse(first.folder, {3, true, "coil slipped", "AB"});
  casefile::addNote(first.folder, "pain after", "2");
  casefile::addNote(session_, "adverse event", "headache");
  writeSendBack(home_, session_, file_);
  EXPECT_EQ(importReturned(clinic_, file_).outcome, ReturnedOutcome::completed);
  const auto session = casefile::readSession(first.folder);
  EXPECT_EQ(report::summarise(session).adverse_events, 1);
  EXPECT_EQ(report::summarise(session).excluded, 1);
  EXPECT_EQ(std::count_if(session.events.begin(), session.events.end(),
                          [](const auto& e) { return e.event == "pain after"; }),
            1);
  EXPECT_EQ(importReturned(clinic_, file_).outcome, ReturnedOutcome::unchanged);
}

TEST_F(ReturnedSessionTest, OfAnotherCaseItIsRefused) {
  const auto other = casefile::CaseStore::createFromFace(folder_.path() / "other",
                                                         {testing::ballCase().scalp, {}, {}, {}}, {}, false);
  EXPECT_THAT(refusalOf([&] { importReturned(other, file_); }), HasSubstr("is of another case"));
  EXPECT_FALSE(fs::exists(other.folder() / "sessions"));
}

TEST_F(ReturnedSessionTest, ADamagedFileLeavesNothing) {
  const auto before = everything();
  const std::string whole = readWholeFile(file_);
  for (const std::size_t cut : {std::size_t(30), whole.size() / 2, whole.size() - 10}) {
    writeWholeFile(file_, whole.substr(0, cut));
    EXPECT_NE(refusalOf([&] { importReturned(clinic_, file_); }), "") << cut;
  }
  writeWholeFile(file_, whole);
  change("pulses.jsonl", [](std::string& text) { text.erase(text.size() / 2); });
  EXPECT_THAT(refusalOf([&] { importReturned(clinic_, file_); }),
              HasSubstr("'pulses.jsonl' in it has changed"));
  change("summary.json",
         [](std::string& text) { text.erase(text.find(",\n \"sha256\""), std::string::npos) += "}"; });
  EXPECT_THAT(refusalOf([&] { importReturned(clinic_, file_); }), HasSubstr("its summary says 40"))
      << "an older file without hashes";
  change("summary.json", [&](std::string& text) {
    const auto name = session_.filename().string();
    text.replace(text.find(name), name.size(), "../../../20261124T000000Z");
  });
  EXPECT_THAT(refusalOf([&] { importReturned(clinic_, file_); }), HasSubstr("is no name of a session"));
  EXPECT_TRUE(everything() == before);
}

TEST_F(ReturnedSessionTest, ASessionOfTheClinicInTheSameSecondStays) {
  const fs::path own = clinic_.folder() / "sessions" / session_.filename();
  fs::create_directories(own);
  writeWholeFile(own / "events.jsonl", R"({"utc": "x", "event": "session started", "detail": ""})"
                                       "\n");
  writeWholeFile(own / "pulses.jsonl", "");
  const auto returned = importReturned(clinic_, file_);
  EXPECT_EQ(returned.outcome, ReturnedOutcome::added);
  EXPECT_NE(returned.folder, own);
  EXPECT_EQ(importReturned(clinic_, file_).outcome, ReturnedOutcome::unchanged);
  EXPECT_EQ(report::summariseSessions(clinic_.folder()).size(), 2u);
}

}  // namespace
}  // namespace facenav::steps
