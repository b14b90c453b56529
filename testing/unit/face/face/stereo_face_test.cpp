// Landmarks of both images joined to one face, on points with known projections and a fake detector.

#include "facenav/face/stereo_face.h"

#include <gtest/gtest.h>

#include <fstream>
#include <random>

#include "facenav/core/error.h"
#include "facenav/face/landmark_model.h"
#include "facenav/geometry/rotation.h"
#include "support/matchers.h"
#include "support/stereo_rigs.h"
#include "support/test_data.h"

namespace facenav::face {
namespace {

using testing::EigenNear;

/// 68 points on a shallow bowl of a face's size, 600 mm in front of the cameras.
std::vector<Eigen::Vector3d> facePoints() {
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 68; ++i) {
    const double x = 15.0 * (i % 9 - 4), y = 17.0 * (i / 9 - 3.5);
    points.emplace_back(x + 20, y + 10, 600 + 0.006 * (x * x + y * y) - (i % 9 == 4 ? 12 : 0));
  }
  return points;
}

/// Fake detector; the first pixel distinguishes the left and the right image (1, 2).
class Stub : public FaceDetector {
 public:
  std::optional<FaceLandmarks> left, right;            // anywhere
  std::optional<FaceLandmarks> left_near, right_near;  // near the last place
  mutable int searches = 0, near_searches = 0;
  mutable std::vector<double> rolls_rad;

  std::optional<FaceLandmarks> detect(const cv::Mat& grey) const override {
    ++searches;
    return isLeft(grey) ? left : right;
  }
  std::optional<FaceLandmarks> detectNear(const cv::Mat& grey, const FaceLandmarks&) const override {
    ++near_searches;
    return isLeft(grey) ? left_near : right_near;
  }
  std::optional<FaceLandmarks> detectAtRoll(const cv::Mat& grey, double roll_rad) const override {
    rolls_rad.push_back(roll_rad);
    return isLeft(grey) ? left : right;
  }

 private:
  static bool isLeft(const cv::Mat& grey) { return grey.at<std::uint8_t>(0, 0) == 1; }
};

cameras::StereoFrame frame() {
  cameras::StereoFrame frame;
  frame.left = cv::Mat(8, 8, CV_8U, cv::Scalar(1));
  frame.right = cv::Mat(8, 8, CV_8U, cv::Scalar(2));
  return frame;
}

FaceLandmarks seen(const cameras::CameraModel& camera, const Eigen::Isometry3d& camera_T_left,
                   const std::vector<Eigen::Vector3d>& points) {
  FaceLandmarks face;
  Eigen::AlignedBox2d box;
  for (const auto& p : points) {
    face.points68.push_back(cameras::project(camera, camera_T_left * p));
    box.extend(face.points68.back());
  }
  face.face = cv::Rect(int(box.min().x()), int(box.min().y()), int(box.sizes().x()), int(box.sizes().y()));
  return face;
}

Stub stubFor(const cameras::StereoRig& rig, const std::vector<Eigen::Vector3d>& points) {
  Stub stub;
  stub.left = stub.left_near = seen(rig.left, Eigen::Isometry3d::Identity(), points);
  stub.right = stub.right_near = seen(rig.right, rig.right_T_left.isometry(), points);
  return stub;
}

TEST(StereoFace, TriangulatesTheLandmarksThatBothImagesShow) {
  for (const auto& rig : {testing::convergingRig(), testing::verticalRig(), testing::rolledRig()}) {
    const Stub stub = stubFor(rig, facePoints());
    const auto face = findStereoFace(stub, rig, frame());
    ASSERT_TRUE(face);
    ASSERT_EQ(face->points_mm.size(), 68u);
    for (int i = 0; i < 68; ++i) EXPECT_THAT(face->points_mm[i], EigenNear(facePoints()[i], 1e-4));
  }
}

TEST(StereoFace, AFaceInOneImageOnlyIsNone) {
  const auto rig = testing::convergingRig();
  Stub stub = stubFor(rig, facePoints());
  stub.left.reset();
  EXPECT_FALSE(findStereoFace(stub, rig, frame()));
  EXPECT_EQ(stub.near_searches, 0) << "without a left face the right image is not searched";
  stub = stubFor(rig, facePoints());
  stub.right.reset(), stub.right_near.reset();
  EXPECT_FALSE(findStereoFace(stub, rig, frame()));
}

TEST(StereoFace, TwoDifferentFacesAreNone) {
  const auto rig = testing::convergingRig();
  Stub stub = stubFor(rig, facePoints());
  for (auto* face : {&stub.right, &stub.right_near})
    for (auto& p : (*face)->points68) p.y() += 0.2 * (*face)->face.width;  // another height: off the lines
  EXPECT_FALSE(findStereoFace(stub, rig, frame()));
}

TEST(StereoFace, ASmallErrorOfTheLandmarksIsNoOtherFace) {
  const auto rig = testing::convergingRig();
  Stub stub = stubFor(rig, facePoints());
  for (auto* face : {&stub.right, &stub.right_near})
    for (auto& p : (*face)->points68) p.y() += 0.02 * (*face)->face.width;
  EXPECT_TRUE(findStereoFace(stub, rig, frame()));
}

/// A detector whose landmarks are misled in one camera; other boxes read some of them rightly.
struct Misled : Stub {
  std::vector<FaceLandmarks> readings(const cv::Mat& grey, const FaceLandmarks& found) const override {
    ++searches;
    FaceLandmarks right_ones = found;
    if (grey.at<std::uint8_t>(0, 0) == 2)
      for (auto& p : right_ones.points68) p.y() -= 0.2 * found.face.width;
    return {found, right_ones};
  }
};

TEST(StereoFace, LandmarksThatMisleadOneCameraAreReadAgainUntilBothAgree) {
  const auto rig = testing::convergingRig();
  Misled misled;
  static_cast<Stub&>(misled) = stubFor(rig, facePoints());
  for (auto& p : misled.right->points68) p.y() += 0.2 * misled.right->face.width;
  const auto face = findStereoFace(misled, rig, frame());
  ASSERT_TRUE(face);
  for (int i = 0; i < 68; ++i) EXPECT_THAT(face->points_mm[i], EigenNear(facePoints()[i], 1e-4));
  static_cast<Stub&>(misled) = stubFor(rig, facePoints());
  ASSERT_TRUE(findStereoFace(misled, rig, frame()));
  EXPECT_EQ(misled.searches, 2) << "landmarks that agree are not read again";
}

/// A detector that finds a poster, or a second person, more surely than the patient.
struct ManyFaces : Stub {
  std::vector<FaceLandmarks> in_left, in_right;
  std::vector<FaceLandmarks> detectAll(const cv::Mat& grey) const override {
    return grey.at<unsigned char>(0, 0) == 1 ? in_left : in_right;
  }
};

TEST(StereoFace, OfSeveralFacesTheTwoCamerasChooseTheOneThatBothSee) {
  const auto rig = testing::convergingRig();
  const Stub stub = stubFor(rig, facePoints());
  FaceLandmarks poster = *stub.left;
  for (auto& p : poster.points68) p += Eigen::Vector2d(30, 90);
  ManyFaces many;
  many.in_left = {poster, *stub.left}, many.in_right = {*stub.right};
  many.in_left[0].score = 3, many.in_left[1].score = -0.2, many.in_right[0].score = 1;
  const auto pair = frame();
  const auto found = findStereoFace(many, rig, pair);
  ASSERT_TRUE(found);
  EXPECT_LT((found->left.points68[0] - stub.left->points68[0]).norm(), 1e-9);
  many.in_right[0].score = -0.2;
  EXPECT_FALSE(findStereoFace(many, rig, pair)) << "two unsure ones";
}

TEST(StereoFace, NearTheLastFaceSearchesNowhereElse) {
  const auto rig = testing::convergingRig();
  Stub stub = stubFor(rig, facePoints());
  const auto last = findStereoFace(stub, rig, frame());
  stub.searches = stub.near_searches = 0;
  ASSERT_TRUE(findStereoFace(stub, rig, frame(), &*last));
  EXPECT_EQ(stub.near_searches, 2);
  stub.left_near.reset();
  EXPECT_FALSE(findStereoFace(stub, rig, frame(), &*last));
  EXPECT_EQ(stub.searches, 0);
}

TEST(StereoFace, AtARollAsksBothImagesForThatRoll) {
  const auto rig = testing::rolledRig();
  Stub stub = stubFor(rig, facePoints());
  ASSERT_TRUE(findStereoFaceAtRoll(stub, rig, frame(), 0.6));
  EXPECT_EQ(stub.rolls_rad, (std::vector<double>{0.6, 0.6}));
  EXPECT_EQ(stub.searches + stub.near_searches, 0);
}

TEST(StereoFace, WithoutLandmarksTheBoxesGiveTheDepth) {
  const auto rig = testing::convergingRig();
  Stub stub = stubFor(rig, facePoints());
  for (auto* face : {&stub.left, &stub.right, &stub.right_near}) (*face)->points68.clear();
  const Eigen::Vector3d middle(15, -5, 640);
  const auto around = [](const Eigen::Vector2d& px) {
    return cv::Rect(int(px.x()) - 60, int(px.y()) - 60, 121, 121);
  };
  stub.left->face = around(cameras::project(rig.left, middle));
  stub.right->face = stub.right_near->face =
      around(cameras::project(rig.right, rig.right_T_left.isometry() * middle));
  const auto face = findStereoFace(stub, rig, frame());
  ASSERT_TRUE(face);
  EXPECT_TRUE(face->points_mm.empty());
  EXPECT_NEAR(depthOf(rig, *face), 640, 8) << "boxes of whole pixels: 4 mm a pixel";
}

TEST(StereoFace, ItsDepthIsTheMedianSoThatOneWildLandmarkIsNoMatter) {
  const auto rig = testing::convergingRig();
  StereoFace face;
  for (const double z : {590.0, 600.0, 610.0, 605.0, 5000.0}) face.points_mm.emplace_back(0, 0, z);
  EXPECT_EQ(depthOf(rig, face), 605.0);
}

/// Motion estimated from landmarks of a moved face: brow, eyes and nose (17..47) rigid.
Eigen::Isometry3d motion() {
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  motion.linear() = expRotation({0.1, -0.2, 0.15});
  motion.translation() = Eigen::Vector3d(12, -8, 20);
  return motion;
}
std::vector<Eigen::Vector3d> movedFace() {
  auto points = facePoints();
  for (auto& p : points) p = motion() * p;
  return points;
}
double missAtFace(const Eigen::Isometry3d& found) {
  return (found * Eigen::Vector3d(20, 10, 600) - motion() * Eigen::Vector3d(20, 10, 600)).norm();
}

TEST(MotionOfLandmarks, IsTheMotionOfARigidFace) {
  const auto found = motionOfLandmarks(facePoints(), movedFace());
  ASSERT_TRUE(found);
  EXPECT_LT((found->matrix() - motion().matrix()).cwiseAbs().maxCoeff(), 1e-6);
}

TEST(MotionOfLandmarks, JawAndMouthAreNoMatter) {
  auto talking = movedFace();
  for (int i = 0; i < 17; ++i) talking[i].y() += 25;
  for (int i = 48; i < 68; ++i) talking[i] += Eigen::Vector3d(0, 15, -10);
  const auto found = motionOfLandmarks(facePoints(), talking);
  ASSERT_TRUE(found);
  EXPECT_LT(missAtFace(*found), 1e-6);
}

TEST(MotionOfLandmarks, AFewWildLandmarksMoveItLittle) {
  auto current = movedFace();
  for (const int i : {18, 25, 31, 40, 46}) current[i] += Eigen::Vector3d(10, -20, 60);  // 5 of 31
  const auto found = motionOfLandmarks(facePoints(), current);
  ASSERT_TRUE(found);
  EXPECT_LT(missAtFace(*found), 0.5);
}

TEST(MotionOfLandmarks, NoiseAveragesOut) {
  std::mt19937 random(5);
  std::normal_distribution<double> normal(0, 1.0);
  auto current = movedFace();
  for (auto& p : current) p += Eigen::Vector3d(normal(random), normal(random), normal(random));
  const auto found = motionOfLandmarks(facePoints(), current);
  ASSERT_TRUE(found);
  EXPECT_LT(missAtFace(*found), 1.0);
  EXPECT_LT(rotationAngle(found->linear().transpose() * motion().linear()), 0.04);
}

TEST(MotionOfLandmarks, WhatIsNoFaceOrNotTheSameOneIsNone) {
  std::mt19937 random(6);
  std::normal_distribution<double> normal(0, 25.0);
  auto scattered = movedFace();
  for (auto& p : scattered) p += Eigen::Vector3d(normal(random), normal(random), normal(random));
  EXPECT_FALSE(motionOfLandmarks(facePoints(), scattered));
  auto few = movedFace();
  few.pop_back();
  EXPECT_FALSE(motionOfLandmarks(facePoints(), few));
  EXPECT_FALSE(motionOfLandmarks({}, {}));
}

TEST(LandmarkModel, WithoutItsFileGivesNothingAndSaysSo) {
  const LandmarkModel model("/nonexistent/model.dat");
  EXPECT_FALSE(model.isInstalled());
  EXPECT_TRUE(model.landmarks(cv::Mat(50, 50, CV_8U, cv::Scalar(9)), {5, 5, 40, 40}).empty());
}

TEST(LandmarkModel, ADamagedFileIsAnErrorThatNamesItEachTime) {
  const testing::TemporaryFolder folder;
  const auto path = folder.path() / "model.dat";
  std::ofstream(path) << "not a predictor";
  const LandmarkModel model(path);
  for (int time = 0; time < 2; ++time) try {
      model.landmarks(cv::Mat(50, 50, CV_8U, cv::Scalar(9)), {5, 5, 40, 40});
      FAIL();
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find(path.string()), std::string::npos);
      EXPECT_NE(std::string(error.what()).find("libdlib-data"), std::string::npos);
    }
}

}  // namespace
}  // namespace facenav::face
