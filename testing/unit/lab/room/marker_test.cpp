#include <gtest/gtest.h>

#include <opencv2/aruco.hpp>

#include "facenav/core/error.h"
#include "facenav/room/room_rig.h"
#include "photo_of_plate.h"

namespace facenav::room {
namespace {

constexpr double kHalf_mm = 30.0;
const Eigen::Vector3d kCorners_mm[4] = {
    {-kHalf_mm, -kHalf_mm, 0}, {kHalf_mm, -kHalf_mm, 0}, {kHalf_mm, kHalf_mm, 0}, {-kHalf_mm, kHalf_mm, 0}};

TEST(MarkerPlate, CornersLieWhereTheTruthSaysAndTheIdIsRead) {
  testing::PlatePhotographer photographer(makeRig({}), plateMesh(84, 84),
                                          makeMarkerLook("4x4_50", 7, 2 * kHalf_mm));
  auto parameters = cv::aruco::DetectorParameters::create();
  parameters->cornerRefinementMethod = cv::aruco::CORNER_REFINE_SUBPIX;
  const auto dictionary = cv::aruco::getPredefinedDictionary(cv::aruco::DICT_4X4_50);
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  double worst_px = 0.0;
  int count = 0;
  for (int view = 0; view < 6; ++view) {
    const auto pose = testing::platePose({-40.0 + 15.0 * view, 30.0 - 17.0 * view, 450.0 + 60.0 * view},
                                         {0.1 * view - 0.3, 0.25 - 0.1 * view, 0.2 * view});
    const auto images = photographer.photograph(pose, 1.5);
    for (std::size_t side = 0; side < 2; ++side) {
      std::vector<std::vector<cv::Point2f>> corners;
      std::vector<int> ids;
      cv::aruco::detectMarkers(images[side], dictionary, corners, ids, parameters);
      ASSERT_EQ(ids, std::vector<int>{7}) << "view " << view << " side " << side;
      for (int corner = 0; corner < 4; ++corner) {
        const Eigen::Vector2d found(corners[0][std::size_t(corner)].x, corners[0][std::size_t(corner)].y);
        const Eigen::Vector2d error = found - photographer.project(side, pose, kCorners_mm[corner]);
        sum += error;
        worst_px = std::max(worst_px, error.norm());
        ++count;
      }
    }
  }
  EXPECT_LT((sum / count).norm(), 0.05) << "no common shift: pixel centres are integers";
  EXPECT_LT(worst_px, 0.6) << "worst single corner";
}

TEST(MarkerPlate, UnknownDictionaryOrIdIsAnError) {
  EXPECT_THROW(makeMarkerLook("4x4_51", 7, 60), Error);
  EXPECT_THROW(makeMarkerLook("4x4_50", 50, 60), Error);
  EXPECT_THROW(makeMarkerLook("4x4_50", -1, 60), Error);
}

}  // namespace
}  // namespace facenav::room
