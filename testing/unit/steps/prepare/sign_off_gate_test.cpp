#include "facenav/prepare/sign_off_gate.h"

#include <gmock/gmock.h>

#include "facenav/core/error.h"
#include "support/test_data.h"
#include "unit/case/casefile/made_case.h"

namespace facenav::steps {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

TEST(SignOffGate, AsksForEveryFindingTheOutlinesAndAName) {
  SignOffClaim claim{"", false, {true, false, false}};
  auto missing = missingForSignOff(claim);
  ASSERT_EQ(missing.size(), 2u);
  EXPECT_EQ(missing[0].gap, SignOffGap::unseen);
  EXPECT_EQ(missing[0].open, 3u);
  EXPECT_EQ(missing[0].all, 4u);
  EXPECT_EQ(missing[1].gap, SignOffGap::no_name);
  claim.findings_seen.assign(3, true);
  claim.by = "A. R.";
  missing = missingForSignOff(claim);
  ASSERT_EQ(missing.size(), 1u) << "the outlines are an item of their own";
  EXPECT_EQ(missing[0].open, 1u);
  claim.outlines_seen = true;
  EXPECT_TRUE(missingForSignOff(claim).empty());
}

TEST(SignOffGate, StaysShutForAModelThatIsSignedOrStillCorrected) {
  SignOffClaim claim{"A. R.", true, {}};
  claim.has_unsaved_correction = true;
  ASSERT_EQ(missingForSignOff(claim).size(), 1u);
  EXPECT_EQ(missingForSignOff(claim)[0].gap, SignOffGap::unsaved_correction);
  claim.is_signed_already = true;
  EXPECT_EQ(missingForSignOff(claim)[0].gap, SignOffGap::signed_already);
}

TEST(SignOffGate, AScanThatIsNotUsableNeedsAReason) {
  SignOffClaim claim{"A. R.", true, {true}, false, false, true, ""};
  ASSERT_EQ(missingForSignOff(claim).size(), 1u);
  EXPECT_EQ(missingForSignOff(claim)[0].gap, SignOffGap::no_reason);
  claim.reason = "a phantom, for training";
  EXPECT_TRUE(missingForSignOff(claim).empty());
  const facenav::testing::TemporaryFolder folder;
  auto prepared = casefile::testing::preparedCase();
  prepared.navigation_check.emplace();
  prepared.navigation_check->findings = {
      {surface::CheckTopic::face, surface::Verdict::not_usable, "there is no face", "the whole head"}};
  const auto store =
      casefile::CaseStore::create(folder.path() / "case", prepared, casefile::testing::provenance(), false);
  ASSERT_TRUE(isNotUsable(store));
  EXPECT_THAT(
      [&] {
        signOffChecked(store, {"A. R.", "", true});
      },
      ThrowsMessage<Error>(HasSubstr("calls this scan not usable: say why")));
  EXPECT_EQ(signOffChecked(store, {"A. R.", "a phantom", true}).note, "a phantom");
}

TEST(SignOffGate, ARejectedScanIsNotTreated) {
  const facenav::testing::TemporaryFolder folder;
  const auto store = casefile::CaseStore::create(folder.path() / "case", casefile::testing::preparedCase(),
                                                 casefile::testing::provenance(), false);
  casefile::signOff(store, {"A. R.", "", true});
  EXPECT_NO_THROW(requireSignOff(store, false));
  EXPECT_THROW(casefile::rejectScan(store, "", "moved"), Error);
  EXPECT_THROW(casefile::rejectScan(store, "A. R.", ""), Error);
  casefile::rejectScan(store, "A. R.", "the head moved");
  EXPECT_EQ(casefile::stateOf(store), casefile::CaseState::rejected);
  EXPECT_THAT([&] { requireSignOff(store, false); },
              ThrowsMessage<Error>(HasSubstr("rejected by A. R.: the head moved")));
  EXPECT_EQ(casefile::listCases(folder.path()).at(0).rejection, "A. R.: the head moved");
  casefile::signOff(store, {"B. R.", "", true});  // taken back
  EXPECT_NO_THROW(requireSignOff(store, false));
}

TEST(SignOffGate, TheCommandLineIsHeldToIt) {
  const facenav::testing::TemporaryFolder folder;
  const auto store = casefile::CaseStore::create(folder.path() / "case", casefile::testing::preparedCase(),
                                                 casefile::testing::provenance(), false);
  EXPECT_THAT(
      [&] {
        signOffChecked(store, {"", "", true});
      },
      ThrowsMessage<Error>(HasSubstr("no name given")));
  EXPECT_THAT(
      [&] {
        signOffChecked(store, {"A. R.", "", false});
      },
      ThrowsMessage<Error>(HasSubstr("the face was removed below the brow")));
  EXPECT_FALSE(casefile::validSignOff(store));
  signOffChecked(store, {"A. R.", "", true});
  EXPECT_TRUE(casefile::validSignOff(store));
  signOffChecked(store, {"B. R.", "", true});
  EXPECT_EQ(casefile::validSignOff(store)->by, "B. R.");
}

}  // namespace
}  // namespace facenav::steps
