#include "search/start_search.h"

#include <gtest/gtest.h>

#include <set>

#include "facenav/core/error.h"
#include "model_field.h"

#include "facenav/geometry/rotation.h"

namespace facenav::registration {
namespace {

using facenav::testing::facing;
using testing::modelFace;
using testing::modelField;
using testing::modelHead;

std::vector<Candidate> starts(const PointCloud<Camera>& face, const AlignmentStart& start = {},
                              SearchWidth width = SearchWidth::any, std::size_t most = 6) {
  TaskMonitor monitor;
  return findStarts(modelField(), face, start, width, most, monitor);
}

void expectNear(const Eigen::Isometry3d& mri_T_camera, const RigidTransform<Camera, Mri>& truth,
                double most_deg, double most_mm) {
  const Eigen::Isometry3d change = mri_T_camera * truth.isometry();
  EXPECT_LT(rotationAngle(change.linear()) / kRadPerDeg, most_deg);
  EXPECT_LT((change * modelField().middle_mm() - modelField().middle_mm()).norm(), most_mm);
}

TEST(StartSearch, TheBestStartIsTheHeadWhateverTheRoll) {
  for (const auto& truth : {facing(10, -5, 0), facing(-30, 10, 130), facing(20, 15, 255)}) {
    const auto found = starts(facenav::testing::measure(modelHead(), truth, {.points = 6000}));
    ASSERT_FALSE(found.empty());
    expectNear(found.front().mri_T_camera, truth, 3.0, 4.0);
  }
}

TEST(StartSearch, GivesDistinctStartsBestFirst) {
  const auto found = starts(modelFace(facing(10, -5, 0)), {}, SearchWidth::any, 5);
  EXPECT_LE(found.size(), 5u);
  for (std::size_t a = 0; a < found.size(); ++a)
    for (std::size_t b = a + 1; b < found.size(); ++b) {
      EXPECT_LE(found[a].cost, found[b].cost);
      EXPECT_TRUE(areDistinct(found[a].mri_T_camera, found[b].mri_T_camera, modelField().middle_mm(),
                              6 * kRadPerDeg, 12.0));
    }
}

TEST(StartSearch, AGuessNearbyIsEnoughForANarrowSearch) {
  const auto truth = facing(-15, 8, 40);
  AlignmentStart start;
  start.guess = RigidTransform<Camera, Mri>::fromIsometry(Eigen::Translation3d(30, -20, 25) *
                                                          facing(0, 0, 25).isometry());
  const auto found = starts(modelFace(truth), start, SearchWidth::near);
  expectNear(found.front().mri_T_camera, truth, 3.0, 4.0);
}

TEST(StartSearch, FindsNoHeadInACloudWithoutPoints) { EXPECT_THROW(starts(PointCloud<Camera>()), Error); }

TEST(StartSearch, NearHeadKeepsTheNumbersOfThePointsAsked) {
  const auto truth = facing(0, 0, 0);
  auto face = modelFace(truth, 300);
  for (std::size_t p = 0; p < 300; p += 2) face.points_mm[p].z() -= 200;  // far before the face
  std::vector<int> asked;
  for (int p = 40; p < 90; ++p) asked.push_back(p);
  const auto near = nearHead(modelField(), face, asked, truth.isometry().inverse(), 10.0);
  std::set<int> expected;
  for (int p = 41; p < 90; p += 2) expected.insert(p);
  EXPECT_EQ(std::set<int>(near.begin(), near.end()), expected);
}

TEST(StartSearch, StopsWhenCancelled) {
  TaskMonitor monitor;
  monitor.cancel();
  EXPECT_THROW(findStarts(modelField(), modelFace(facing(0, 0, 0)), {}, SearchWidth::any, 4, monitor),
               Cancelled);
}

}  // namespace
}  // namespace facenav::registration
