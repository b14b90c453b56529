// The right camera's pose from matches alone, epipolar distances, and triangulation's error, on rays made
// from a known rig.

#include "relative_pose.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "facenav/cameras/marker_dictionary.h"
#include "facenav/cameras/rig_motion.h"
#include "facenav/cameras/stereo_rig.h"
#include "facenav/core/error.h"
#include "facenav/health/rig_monitor.h"
#include "neighbourhood.h"
#include "skin_evenness.h"
#include "support/matchers.h"
#include "support/stereo_rigs.h"

namespace facenav::health {

using namespace cameras;
namespace {

using testing::EigenNear;

Eigen::Isometry3d truePose() { return testing::convergingRig().right_T_left.isometry(); }

/// Points of a head's size about 600 mm away, with `noise` (in x/z) added across and along.
std::vector<RayPair> rays(const Eigen::Isometry3d& right_T_left, int count, double noise, unsigned seed = 1) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> side(-90, 90), depth(540, 680);
  std::normal_distribution<double> normal(0, 1);
  std::vector<RayPair> all;
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3d p(side(random), side(random), depth(random)), q = right_T_left * p;
    RayPair pair{p.hnormalized(), q.hnormalized(), 2.5e-4};
    for (auto* ray : {&pair.left, &pair.right})
      *ray += noise * Eigen::Vector2d(normal(random), normal(random));
    all.push_back(pair);
  }
  return all;
}

Eigen::Isometry3d turnedBy(const Eigen::Vector3d& deg, const Eigen::Isometry3d& pose) {
  Eigen::Isometry3d other = pose;
  other.linear() = expRotation(deg * M_PI / 180) * pose.linear();
  return other;
}

double turn_deg(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b) {
  return rotationAngle(a.linear() * b.linear().transpose()) * 180 / M_PI;
}
double baselineAngle_deg(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b) {
  return std::acos(std::min(1.0, a.translation().normalized().dot(b.translation().normalized()))) * 180 /
         M_PI;
}

TEST(RelativePose, IsFoundFromAKnockedStart) {
  const auto matches = rays(truePose(), 120, 0);
  Eigen::Isometry3d start = turnedBy({0.4, -0.5, 0.5}, truePose());
  start.translation() = expRotation({0.005, -0.01, 0.004}) * start.translation();
  const auto found = refinePose(start, matches);
  EXPECT_LT(turn_deg(found.right_T_left, truePose()), 0.02);
  EXPECT_LT(baselineAngle_deg(found.right_T_left, truePose()), 0.1);
  EXPECT_NEAR(found.right_T_left.translation().norm(), start.translation().norm(), 1e-6)
      << "matches say nothing about the baseline's length";
}

TEST(RelativePose, ATenthOfWildMatchesMovesItLittle) {
  auto matches = rays(truePose(), 200, 5e-5);
  const auto clean = refinePose(turnedBy({0.5, 0, 0.5}, truePose()), matches).right_T_left;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> wild(-0.05, 0.05);
  for (std::size_t i = 0; i < 20; ++i) matches[i].right += Eigen::Vector2d(wild(random), wild(random));
  const auto found = refinePose(turnedBy({0.5, 0, 0.5}, truePose()), matches).right_T_left;
  EXPECT_LT(turn_deg(found, clean), 0.1);
}

TEST(RelativePose, AnExactStartIsKept) {
  const auto found = refinePose(truePose(), rays(truePose(), 60, 0));
  EXPECT_LT(turn_deg(found.right_T_left, truePose()), 1e-4);
  EXPECT_LT(found.cost, 1e-6);
}

TEST(RelativePose, ATightPriorHoldsItWhereItWasThought) {
  const auto matches = rays(truePose(), 120, 0);
  const auto start = turnedBy({0.3, 0, 0}, truePose());
  const PosePrior tight{1e-7, 1e-5}, loose{1.0, 1000.0};
  EXPECT_LT(turn_deg(refinePose(start, matches, &tight).right_T_left, start), 0.01);
  EXPECT_LT(turn_deg(refinePose(start, matches, &loose).right_T_left, truePose()), 0.05);
}

TEST(EpipolarDistance, IsZeroOnTheLineAndCountsSigmas) {
  auto pair = rays(truePose(), 1, 0)[0];
  EXPECT_NEAR(epipolarDistance(truePose(), pair), 0, 1e-9);
  pair.right.y() += pair.sigma;  // the lines are nearly level: one sigma across, in one image of two
  const double one = epipolarDistance(truePose(), pair);
  EXPECT_NEAR(one, 1.0, 0.1);
  pair.sigma *= 2;
  EXPECT_NEAR(epipolarDistance(truePose(), pair), one / 2, 1e-9);
}

TEST(EpipolarDistance, HasOppositeSignsOnOppositeSides) {
  auto above = rays(truePose(), 1, 0)[0], below = above;
  above.right.y() -= 1e-3, below.right.y() += 1e-3;
  EXPECT_LT(signedEpipolarDistance(truePose(), above) * signedEpipolarDistance(truePose(), below), 0);
  EXPECT_NEAR(std::abs(signedEpipolarDistance(truePose(), above)), epipolarDistance(truePose(), above), 1e-9);
}

TEST(EpipolarDistance, OfAPointBehindTheCamerasIsInfinite) {
  const Eigen::Vector3d behind(10, 20, -600);
  const RayPair pair{behind.hnormalized(), (truePose() * behind).hnormalized(), 2.5e-4};
  EXPECT_NEAR(signedEpipolarDistance(truePose(), pair), 0, 1e-9) << "on the line all the same";
  EXPECT_TRUE(std::isinf(epipolarDistance(truePose(), pair)));
}

TEST(EpipolarError, IsZeroAlongTheLineAndGrowsAcrossIt) {
  StereoRig rig;  // parallel cameras: lines are rows
  rig.width_px = 640, rig.height_px = 480;
  rig.left.k = rig.right.k = testing::cameraMatrix(800, 320, 240);
  rig.right_T_left = {Eigen::Quaterniond::Identity(), {-100, 0, 0}};
  for (const double disparity : {20.0, 100.0, 250.0})
    EXPECT_NEAR(epipolarError_px(rig, {400, 200}, {400 - disparity, 200}), 0, 1e-9)
        << "any depth is on the line";
  for (const double off : {-3.0, 0.5, 2.0})
    EXPECT_NEAR(epipolarError_px(rig, {400, 200}, {300, 200 + off}), std::abs(off), 0.01);
}

TEST(EpipolarResidual, IsPositiveWhereTheRightImageIsLower) {
  const StereoRig rig = testing::convergingRig();
  const Eigen::Vector3d p(10, 20, 610);
  const Eigen::Vector2d left = project(rig.left, p),
                        right = project(rig.right, rig.right_T_left.isometry() * p);
  EXPECT_NEAR(epipolarResidual_px(rig, left, right), 0, 1e-6);
  EXPECT_NEAR(epipolarResidual_px(rig, left, right + Eigen::Vector2d(0, 1.5)), 1.5, 0.1);
  EXPECT_NEAR(epipolarResidual_px(rig, left, right - Eigen::Vector2d(0, 1.5)), -1.5, 0.1);
}

TEST(Triangulation, ItsDepthErrorIsThatOfTheDisparity) {
  StereoRig rig;
  rig.width_px = 640, rig.height_px = 480;
  rig.left.k = rig.right.k = cv::Matx33d(800, 0, 320, 0, 800, 240, 0, 0, 1);
  rig.right_T_left = {Eigen::Quaterniond::Identity(), {-120, 0, 0}};
  for (const double z : {400.0, 600.0, 900.0}) {
    const Eigen::Vector3d p(30, -20, z);
    const Eigen::Vector2d left = project(rig.left, p),
                          right = project(rig.right, p + Eigen::Vector3d(-120, 0, 0));
    const double step_px = 0.01;
    const double moved_mm = triangulate(rig, left, right - Eigen::Vector2d(step_px, 0)).mm.z() - z;
    EXPECT_NEAR(moved_mm, -z * z / (800 * 120) * step_px, 2e-3 * z * z / (800 * 120) * step_px)
        << "z^2 / (f b)";
  }
}

TEST(Triangulation, DoesNotDependOnWhichCameraIsCalledLeft) {
  const StereoRig rig = testing::convergingRig();
  StereoRig swapped = rig;
  std::swap(swapped.left, swapped.right);
  swapped.right_T_left =
      RigidTransform<RightCamera, Camera>::fromIsometry(rig.right_T_left.isometry().inverse());
  const Eigen::Vector2d left(350, 220), right(290, 231);
  const Eigen::Vector3d p = triangulate(rig, left, right).mm, q = triangulate(swapped, right, left).mm;
  EXPECT_THAT(q, EigenNear(Eigen::Vector3d(rig.right_T_left.isometry() * p), 1e-5));
  EXPECT_NEAR(epipolarError_px(rig, left, right), epipolarError_px(swapped, right, left), 1e-6);
}

TEST(RigMotion, TurnsTheRightCameraAboutItsOwnCentre) {
  const StereoRig rig = testing::convergingRig();
  Vector6d motion = Vector6d::Zero();
  motion.head<3>() = Eigen::Vector3d(0.01, -0.02, 0.005);
  const StereoRig other = turned(rig, motion);
  EXPECT_THAT(other.right_T_left.inverse().translation_mm(),
              EigenNear(rig.right_T_left.inverse().translation_mm(), 1e-9))
      << "the camera stays where it stands";
  EXPECT_NEAR(rotationAngle(other.right_T_left.rotation() * rig.right_T_left.rotation().transpose()),
              motion.norm(), 1e-9);
  EXPECT_TRUE(other.left.k == rig.left.k);
}

TEST(RigUncertainty, WithoutACovarianceGrowsWithTheReprojectionError) {
  StereoRig rig = testing::convergingRig();
  const auto spread = [&](double rms_px) {  // of a point's depth, mm
    rig.rms_px = rms_px;
    const Eigen::Vector3d p(0, 0, 600);
    const Eigen::Vector2d left = project(rig.left, p),
                          right = project(rig.right, rig.right_T_left.isometry() * p);
    double squares = 0;
    for (const auto& other : uncertaintyOf(rig).one_sigma)
      squares += std::pow(triangulate(other, left, right).mm.z() - 600, 2);
    return std::sqrt(squares);
  };
  const double usual = spread(0.2);
  EXPECT_GT(usual, 0.05);
  EXPECT_LT(usual, 5.0);
  EXPECT_NEAR(spread(0.4) / usual, 2.0, 0.05);
  rig.rms_px.reset();
  EXPECT_NEAR(uncertaintyOf(rig).lens_px, 0.05, 1e-12) << "0.2 px are supposed";
}

TEST(RigUncertainty, OfACovarianceIsItsSquareRootAlongEachAxis) {
  StereoRig rig = testing::convergingRig();
  const int n = 2 * (4 + 5) + 6;
  rig.covariance = cv::Mat::zeros(n, n, CV_64F);
  rig.covariance.at<double>(0, 0) = 0.5 * 0.5;          // left fx, px^2
  rig.covariance.at<double>(n - 1, n - 1) = 0.1 * 0.1;  // shift along z, mm^2
  double focal = 0, shift = 0, turn = 0;
  for (const auto& other : uncertaintyOf(rig).one_sigma) {
    focal += std::pow(other.left.k(0, 0) - rig.left.k(0, 0), 2);
    const Eigen::Isometry3d& pose = other.right_T_left.isometry();
    shift += (pose.translation() - rig.right_T_left.translation_mm()).squaredNorm();
    turn += std::pow(rotationAngle(pose.linear() * rig.right_T_left.rotation().transpose()), 2);
    EXPECT_TRUE(other.right.k == rig.right.k);
  }
  EXPECT_NEAR(focal / (0.5 * 0.5), shift / (0.1 * 0.1), 1e-3) << "the same inflation for all";
  EXPECT_GE(focal, 0.5 * 0.5);
  EXPECT_NEAR(turn, 0, 1e-16);
}

std::vector<PixelPair> grid(const Eigen::Matrix2d& map, const Eigen::Vector2d& shift) {
  std::vector<PixelPair> pairs;
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x) {
      const Eigen::Vector2d left(100 + 15 * x, 80 + 15 * y);
      pairs.push_back({left, map * left + shift});
    }
  return pairs;
}

TEST(Neighbourhood, OfAShiftIsTheShift) {
  const auto pairs = grid(Eigen::Matrix2d::Identity(), {-40, 3});
  const auto here = neighbourhood(pairs, {150, 130});
  ASSERT_TRUE(here);
  EXPECT_THAT(here->at, EigenNear(Eigen::Vector2d(110, 133), 1e-3));
  EXPECT_LT((here->map - Eigen::Matrix2d::Identity()).norm(), 1e-5);
}

TEST(Neighbourhood, FollowsAStretchPartOfTheWay) {
  Eigen::Matrix2d stretch;
  stretch << 1.2, 0, 0, 1;
  const auto here = neighbourhood(grid(stretch, {0, 0}), {152.5, 132.5});  // in the middle of four seeds
  ASSERT_TRUE(here);
  EXPECT_NEAR(here->at.x(), 1.2 * 152.5, 0.1);
  EXPECT_GT(here->map(0, 0), 1.05) << "the prior holds it back, the seeds pull";
  EXPECT_LT(here->map(0, 0), 1.2);
  EXPECT_NEAR(here->map(1, 1), 1.0, 1e-6);
}

TEST(Neighbourhood, NeedsSeedsNearby) {
  const auto pairs = grid(Eigen::Matrix2d::Identity(), {0, 0});
  EXPECT_FALSE(neighbourhood(pairs, {600, 400}));
  EXPECT_FALSE(neighbourhood({pairs.begin(), pairs.begin() + 2}, {110, 85}));
  EXPECT_TRUE(neighbourhood({pairs.begin(), pairs.begin() + 3}, {110, 85}));
}

TEST(Neighbourhood, NearestGivesTheNearestFirstAndNoneBeyondReach) {
  const std::vector<PixelPair> pairs{{{10, 0}, {}}, {{1, 0}, {}}, {{5, 0}, {}}, {{100, 0}, {}}};
  EXPECT_EQ(nearest(pairs, {0, 0}, 3, 50), (std::vector<std::size_t>{1, 2, 0}));
  EXPECT_EQ(nearest(pairs, {0, 0}, 2, 50), (std::vector<std::size_t>{1, 2}));
  EXPECT_EQ(nearest(pairs, {0, 0}, 9, 5.0), (std::vector<std::size_t>{1})) << "the reach itself is too far";
}

TEST(Neighbourhood, WarpedWithoutAMapIsThePatchItself) {
  cv::Mat image(40, 50, CV_8U);
  for (int y = 0; y < 40; ++y)
    for (int x = 0; x < 50; ++x) image.at<std::uint8_t>(y, x) = std::uint8_t(5 * x + (y % 4));
  const cv::Mat patch = warped(image, {20, 15}, Eigen::Matrix2d::Identity(), 7);
  EXPECT_EQ(cv::norm(patch, image(cv::Rect(17, 12, 7, 7)), cv::NORM_INF), 0);
  Eigen::Matrix2d twice = 2 * Eigen::Matrix2d::Identity();
  EXPECT_EQ(int(warped(image, {20, 15}, twice, 5).at<std::uint8_t>(2, 3)),
            int(image.at<std::uint8_t>(15, 22)));
}

TEST(SharedResidual, KeepsWhatNeighboursShareAndDropsWhatTheyDoNot) {
  auto matches = rays(truePose(), 400, 0, 9);
  std::vector<Eigen::Vector2d> left_px;
  for (const auto& pair : matches) left_px.push_back(800 * pair.left);
  EXPECT_NEAR(sharedResidual(truePose(), matches, left_px, 10), 0, 1e-6);
  auto lifted = matches;
  for (auto& pair : lifted)
    pair.right.y() += 3 * pair.sigma;  // all have the same sign: about 3 sigmas, less its own share
  const double shared = sharedResidual(truePose(), lifted, left_px, 100);
  EXPECT_NEAR(shared, 3.0, 0.3);
  EXPECT_NEAR(sharedResidual(truePose(), lifted, left_px, 1.0), 1.0, 1e-9) << "limited";
  for (std::size_t i = 0; i < lifted.size(); ++i)
    lifted[i].right.y() = matches[i].right.y() + (i % 4 == 0 ? 3 * lifted[i].sigma : 0);
  EXPECT_LT(sharedResidual(truePose(), lifted, left_px, 100), 1.2)
      << "one in four is outvoted by its neighbours";
}

TEST(MarkerDictionary, NamesAreThoseOfTheFormatInAnyCase) {
  EXPECT_EQ(predefinedDictionary("4x4_50"), 0) << "cv::aruco::DICT_4X4_50";
  EXPECT_EQ(predefinedDictionary("DICT_4X4_1000"), 3);
  EXPECT_EQ(predefinedDictionary("5X5_50"), 4);
  EXPECT_EQ(predefinedDictionary("dict_7x7_1000"), 15);
  EXPECT_EQ(predefinedDictionary("aruco_original"), 16);
  EXPECT_EQ(predefinedDictionary("AprilTag_36h11"), 20);
}

TEST(MarkerDictionary, AnUnknownNameIsAnErrorThatListsTheKnownOnes) {
  for (const char* name : {"", "4x4", "8x8_50", "4x4_50 "}) try {
      predefinedDictionary(name);
      FAIL() << name;
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find("6x6_250"), std::string::npos);
    }
}

}  // namespace
}  // namespace facenav::health
