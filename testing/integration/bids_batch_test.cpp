// facenav-bids on a dataset with a good head, a damaged one and one session: a failure affects no other
// image, and a second run continues where the first stopped.

#include <gmock/gmock.h>

#include <sstream>

#include "facenav/casefile/case_store.h"
#include "support/ball_case.h"
#include "support/command_line.h"

namespace facenav::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

class BidsBatch : public ::testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(dataset());
    std::ofstream(dataset() / "dataset_description.json") << R"({"Name": "test", "BIDSVersion": "1.8.0"})";
  }
  fs::path dataset() const { return folder_.path() / "bids"; }
  fs::path output() const { return folder_.path() / "out"; }
  fs::path addImage(const std::string& folder, const std::string& name) {
    fs::create_directories(dataset() / folder / "anat");
    return dataset() / folder / "anat" / (name + "_T1w.nii.gz");
  }
  CommandResult run(const std::string& more = {}) {
    return runProgram(FACENAV_BIDS, dataset().string() + " " + output().string() + " participant " + more);
  }
  TemporaryFolder folder_;
};

TEST_F(BidsBatch, AFailureStaysAloneAndASecondRunGoesOn) {
  FACENAV_NEEDS(colin27());
  fs::copy_file(colin27(), addImage("sub-good/ses-a", "sub-good_ses-a"));
  std::ofstream(addImage("sub-bad", "sub-bad")) << "no volume";
  const auto first = run();
  EXPECT_EQ(first.status, 1);
  EXPECT_THAT(first.output, HasSubstr("1 prepared, 0 there already, 1 failed"));
  EXPECT_THAT(first.output, HasSubstr("sub-bad_T1w.nii.gz"));  // the reason is in the table
  EXPECT_NO_THROW(casefile::CaseStore::open(output() / "sub-good/ses-a/case"));
  EXPECT_TRUE(fs::exists(output() / "sub-good/ses-a/anat/sub-good_ses-a_desc-brain_mask.nii.gz"));
  EXPECT_FALSE(fs::exists(output() / "sub-bad/case"));

  const auto second = run("--participant-label sub-good");
  EXPECT_EQ(second.status, 0);
  EXPECT_THAT(second.output, HasSubstr("0 prepared, 1 there already, 0 failed"));
  EXPECT_THAT(second.output, Not(HasSubstr("sub-bad")));
}

/// Runs the workflow with a fake facenav-bids that fails for one participant.
TEST_F(BidsBatch, TheSnakemakeWorkflowRunsEachParticipantAndGoesOnAfterAFailure) {
  if (std::system("command -v snakemake >/dev/null") != 0) GTEST_SKIP() << "snakemake is not installed";
  const fs::path program = folder_.path() / "stand_in", broken = folder_.path() / "broken";
  std::ofstream(program) << "#!/bin/sh\necho \"$@\" >>" << (folder_.path() / "calls").string()
                         << "\necho \"$@\"\ncase \"$5\" in 02) test ! -e " << broken.string() << " ;; esac\n";
  fs::permissions(program, fs::perms::owner_all);
  for (const char* label : {"01", "02", "03"})
    std::ofstream(addImage(std::string("sub-") + label, std::string("sub-") + label)) << "a volume";
  const auto workflow = [&] {
    return runProgram(
        "snakemake", "-s '" FACENAV_SOURCE_DIR "/resources/snakemake/Snakefile' --cores 2 --keep-going -d '" +
                         folder_.path().string() + "' --config bids='" + dataset().string() + "' out='" +
                         output().string() + "' facenav_bids='" + program.string() + "'");
  };
  std::ofstream(broken) << "yes";
  EXPECT_EQ(workflow().status, 1);
  EXPECT_TRUE(fs::exists(output() / "logs/sub-01.done"));
  EXPECT_FALSE(fs::exists(output() / "logs/sub-02.done"));
  EXPECT_TRUE(fs::exists(output() / "logs/sub-03.done"));
  EXPECT_THAT(readText(output() / "participants_table.txt"), HasSubstr("--table")) << "written all the same";

  fs::remove(broken);
  const auto first = fs::last_write_time(output() / "logs/sub-01.done");
  EXPECT_EQ(workflow().status, 0);
  EXPECT_TRUE(fs::exists(output() / "logs/sub-02.done"));
  EXPECT_EQ(fs::last_write_time(output() / "logs/sub-01.done"), first) << "what is there is not done again";
  EXPECT_THAT(readText(output() / "participants_table.txt"), HasSubstr("participant --table"));
  std::istringstream calls(readText(folder_.path() / "calls"));
  int runs = 0;
  for (std::string call; std::getline(calls, call);) runs += call.find("--table") == std::string::npos;
  EXPECT_EQ(runs, 4) << "01, 02, 03, then 02 again: no table runs anything";
}

TEST_F(BidsBatch, TheTableSaysWhatIsThereWithoutARun) {
  casefile::CaseStore::create(
      [&] {
        fs::create_directories(output() / "sub-01");
        return output() / "sub-01/case";
      }(),
      ballCase(), {}, false);
  fs::create_directories(output() / "logs");
  std::ofstream(output() / "logs/sub-02.log") << "facenav: no head in it\n";
  for (const char* label : {"01", "02", "03"})
    std::ofstream(addImage(std::string("sub-") + label, std::string("sub-") + label)) << "a volume";
  const auto table = run("--table");
  EXPECT_EQ(table.status, 1);
  EXPECT_THAT(table.output, HasSubstr("no head in it"));
  EXPECT_THAT(table.output, HasSubstr("0 prepared, 1 there already, 1 failed, 1 not run"));
  EXPECT_FALSE(fs::exists(output() / "sub-03"));
}

/// Puts a stand-in for the tool beside a copy of facenav-bids: it waits, or finds that another run was first.
TEST_F(BidsBatch, AKilledBatchEndsItsJobAndAFinishedSubjectIsNotFailed) {
  const fs::path program = folder_.path() / "facenav-bids", tool = folder_.path() / "facenav";
  fs::copy_file(FACENAV_BIDS, program);
  std::ofstream(addImage("sub-01", "sub-01")) << "a volume";
  std::ofstream(tool) << "#!/bin/sh\necho $$ >" << (folder_.path() / "pid").string() << "\nexec sleep 60\n";
  fs::permissions(tool, fs::perms::owner_all);
  const std::string arguments = dataset().string() + " " + output().string() + " participant";
  const std::string pid = (folder_.path() / "pid").string();
  const auto killed = runProgram(  // a process that has ended but was not waited for is dead, too
      "/bin/sh", "-c '" + program.string() + " " + arguments + " & batch=$!; while test ! -s " + pid +
                     "; do sleep 0.05; done; kill -9 $batch; sleep 0.5; "
                     "grep -q \"^State:.[RSDT]\" /proc/$(cat " +
                     pid + ")/status'");
  EXPECT_NE(killed.status, 0) << "the job has ended with its batch";

  const fs::path finished = folder_.path() / "finished";
  casefile::CaseStore::create(finished, ballCase(), {}, false);
  std::ofstream(tool) << "#!/bin/sh\nmv " << finished.string()
                      << " $4\necho 'a case exists there already'\nexit 1\n";
  const auto resumed = runProgram(program.string(), arguments);
  EXPECT_EQ(resumed.status, 0) << resumed.output;
  EXPECT_THAT(resumed.output, HasSubstr("0 prepared, 1 there already, 0 failed"));
}

TEST_F(BidsBatch, WrongInputIsOneLine) {
  EXPECT_THAT(run().errors, HasSubstr("no T1w image"));
  std::ofstream(addImage("sub-01", "sub-01")) << "no volume";
  EXPECT_THAT(run("--participant-label 02").errors, HasSubstr("'02'"));
  EXPECT_EQ(runProgram(FACENAV_BIDS, dataset().string() + " " + output().string() + " group").status, 2);
  fs::remove(dataset() / "dataset_description.json");
  EXPECT_THAT(run().errors, HasSubstr("dataset_description.json"));
  EXPECT_FALSE(fs::exists(output()));
}

}  // namespace
}  // namespace facenav::testing
