// facenav-bids on a dataset of a good head, a damaged one and one session: failures stay alone, a second run
// goes on where the first stopped.

#include <gmock/gmock.h>

#include "facenav/casefile/case_store.h"
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
  EXPECT_THAT(first.output, HasSubstr("sub-bad_T1w.nii.gz"));  // the reason, in the table
  EXPECT_NO_THROW(casefile::CaseStore::open(output() / "sub-good/ses-a/case"));
  EXPECT_TRUE(fs::exists(output() / "sub-good/ses-a/anat/sub-good_ses-a_desc-brain_mask.nii.gz"));
  EXPECT_FALSE(fs::exists(output() / "sub-bad/case"));

  const auto second = run("--participant-label sub-good");
  EXPECT_EQ(second.status, 0);
  EXPECT_THAT(second.output, HasSubstr("0 prepared, 1 there already, 0 failed"));
  EXPECT_THAT(second.output, Not(HasSubstr("sub-bad")));
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
