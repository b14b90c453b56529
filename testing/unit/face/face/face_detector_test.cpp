// The detector on the public-domain portrait of python3-skimage; eye corners marked by hand.

#include <gtest/gtest.h>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "facenav/face/face_landmarks.h"
#include "facenav/face/landmark_model.h"
#include "support/synthetic_face.h"
#include "support/test_data.h"

namespace facenav::face {
namespace {

cv::Mat portrait() { return cv::imread(testing::SyntheticFace::portraitPath(), cv::IMREAD_GRAYSCALE); }

cv::Matx23d turn(const cv::Mat& image, double degrees) {
  const cv::Mat m = cv::getRotationMatrix2D({image.cols / 2.f, image.rows / 2.f}, degrees, 1.0);
  return {m.at<double>(0, 0), m.at<double>(0, 1), m.at<double>(0, 2),
          m.at<double>(1, 0), m.at<double>(1, 1), m.at<double>(1, 2)};
}

TEST(FaceDetector, FindsThePortraitAndItsEyesUprightAndLeaning) {
  FACENAV_NEEDS(testing::SyntheticFace::portraitPath());
  FACENAV_NEEDS(LandmarkModel::defaultPath());
  const auto detector = makeFaceDetector();
  for (double degrees : {0.0, 25.0, -45.0, 90.0}) {
    const cv::Mat image = portrait();
    const cv::Matx23d m = turn(image, degrees);
    cv::Mat turned;
    cv::warpAffine(image, turned, m, image.size());
    const auto face = detector->detect(turned);
    ASSERT_TRUE(face) << degrees;
    ASSERT_EQ(face->points68.size(), 68u);
    const auto expect = [&](int landmark, double x, double y) {
      const cv::Vec2d p = m * cv::Vec3d(x, y, 1);
      EXPECT_LT((face->points68[landmark] - Eigen::Vector2d(p[0], p[1])).norm(), 6.0)
          << degrees << " landmark " << landmark;
    };
    expect(36, 195, 100);  // outer corner of the eye on the left of the image
    expect(45, 259, 104);  // and on the right
    const auto again = detector->detectNear(turned, *face);
    ASSERT_TRUE(again) << degrees;
    EXPECT_LT((again->points68[30] - face->points68[30]).norm(), 3.0);
  }
}

TEST(FaceOutline, HoldsTheFaceAndNotTheRestOfItsBox) {
  FaceLandmarks face;
  face.face = {100, 200, 100, 120};
  const auto isIn = [&](double x, double y) {
    return cv::pointPolygonTest(outlineOf(face), {float(x), float(y)}, false) > 0;
  };
  EXPECT_TRUE(isIn(150, 260));   // middle
  EXPECT_FALSE(isIn(103, 317));  // corner of the box: a shoulder
  EXPECT_FALSE(isIn(197, 203));
  face.points68.assign(68, {150, 260});
  for (int i = 0; i <= 16; ++i)  // jaw
    face.points68[i] = {150 - 40 * std::cos(M_PI * i / 16), 250 + 60 * std::sin(M_PI * i / 16)};
  for (int i = 17; i <= 26; ++i) face.points68[i] = {115.0 + 7 * (i - 17), 235};  // brows
  face.points68[33] = {150, 275};                                                 // base of the nose
  EXPECT_TRUE(isIn(150, 300));                                                    // chin
  EXPECT_TRUE(isIn(150, 212));                                                    // forehead, above the brows
  EXPECT_FALSE(isIn(150, 200));                                                   // hair
  EXPECT_FALSE(isIn(103, 317));
}

TEST(FaceDetector, FindsNothingInNoise) {
  cv::Mat noise(480, 640, CV_8U);
  cv::RNG random(7);
  random.fill(noise, cv::RNG::UNIFORM, 0, 255);
  const auto no_landmarks = std::make_shared<LandmarkModel>("/nonexistent/model.dat");  // not needed here
  EXPECT_FALSE(makeFaceDetector(no_landmarks)->detect(noise));
}

TEST(FaceDetector, WithoutTheLandmarkModelGivesTheBoxAlone) {
  FACENAV_NEEDS(testing::SyntheticFace::portraitPath());
  const auto face =
      makeFaceDetector(std::make_shared<LandmarkModel>("/nonexistent/model.dat"))->detect(portrait());
  ASSERT_TRUE(face);
  EXPECT_TRUE(face->points68.empty());
  EXPECT_TRUE(face->face.contains({224, 120}));
}

}  // namespace
}  // namespace facenav::face
