#include "facenav/casefile/navigation_check_file.h"

#include <gtest/gtest.h>

#include <fstream>

#include "facenav/core/error.h"
#include "made_case.h"
#include "support/test_data.h"

namespace facenav::casefile {
namespace {

namespace fs = std::filesystem;

surface::NavigationCheck madeCheck() {
  surface::NavigationCheck check;
  check.findings = {
      {surface::CheckTopic::face, surface::Verdict::fine, "whole", ""},
      {surface::CheckTopic::wrap_around, surface::Verdict::caution, "much", "a larger field of view"}};
  check.landmarks.points = {{"nasion", Point<Mri>(1.0, 90.5, -20.25), 1.5, false},
                            {"pronasale", Point<Mri>(1.0, 112.0, -55.0), 1.0, true}};
  check.landmarks.right = Direction<Mri>(Eigen::Vector3d(1, 0.1, 0));
  check.measures = {{"nose length", "nasion", "pronasale", 40.8, 3.5, surface::UsualRange{37, 58}, true},
                    {"free", "a", "b", 12.0, 2.0, std::nullopt, false}};
  return check;
}

TEST(NavigationCheckFile, WhatIsWrittenIsRead) {
  const facenav::testing::TemporaryFolder folder;
  const auto path = folder.path() / "navigation_check.json";
  const auto written = madeCheck();
  writeNavigationCheck(written, path);
  EXPECT_EQ(fs::status(path).permissions() & fs::perms::all, fs::perms::owner_read | fs::perms::owner_write);
  const auto read = readNavigationCheck(path);
  EXPECT_EQ(read.verdict(), surface::Verdict::caution);
  ASSERT_EQ(read.findings.size(), 2u);
  EXPECT_EQ(read.findings[1].topic, surface::CheckTopic::wrap_around);
  EXPECT_EQ(read.findings[1].ask, "a larger field of view");
  ASSERT_EQ(read.landmarks.points.size(), 2u);
  EXPECT_FALSE(read.landmarks.points[0].is_cut);
  EXPECT_TRUE(read.landmarks.points[1].is_cut);
  EXPECT_LT((read.landmarks.points[0].point.mm - written.landmarks.points[0].point.mm).norm(), 1e-3);
  EXPECT_LT((read.landmarks.right.v - written.landmarks.right.v).norm(), 1e-3);
  ASSERT_EQ(read.measures.size(), 2u);
  EXPECT_TRUE(read.measures[0].is_lower_bound);
  ASSERT_TRUE(read.measures[0].usual);
  EXPECT_EQ(read.measures[0].usual->high_mm, 58);
  EXPECT_FALSE(read.measures[1].usual);
}

TEST(NavigationCheckFile, RefusesAnotherVerdictOrTopic) {
  const facenav::testing::TemporaryFolder folder;
  const auto path = folder.path() / "navigation_check.json";
  for (const char* finding :
       {R"("topic": "face", "verdict": "good")", R"("topic": "faces", "verdict": "fine")"}) {
    std::ofstream(path) << R"({"findings": [{)" << finding << R"(, "finding": ""}], )"
                        << R"("landmarks": [], "measures": []})";
    EXPECT_THROW(readNavigationCheck(path), Error) << finding;
  }
}

TEST(NavigationCheckFile, IsPartOfTheCaseAndAbsentInOlderOnes) {
  const facenav::testing::TemporaryFolder folder;
  auto prepared = testing::preparedCase();
  EXPECT_FALSE(navigationCheckOf(CaseStore::create(folder.path() / "old", prepared, {}, false)));
  prepared.navigation_check = madeCheck();
  const auto store = CaseStore::create(folder.path() / "new", prepared, {}, false);
  ASSERT_TRUE(navigationCheckOf(store));
  EXPECT_EQ(navigationCheckOf(store)->measures.size(), 2u);
}

}  // namespace
}  // namespace facenav::casefile
