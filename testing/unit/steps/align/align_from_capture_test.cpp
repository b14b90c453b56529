#include "facenav/align/align_from_capture.h"
#include "facenav/measured_face/projected_dots.h"

#include <gtest/gtest.h>

#include "support/ball_mesh.h"
#include "support/matchers.h"
#include "support/stereo_scene.h"
#include "unit/treat/session/session_fakes.h"

namespace facenav::steps {
namespace {

/// Landmarks of a face that looks at the left camera from 600 mm: 68 points, projected into both images.
class FakeDetector : public face::FaceDetector {
 public:
  FakeDetector(const cameras::StereoRig& rig, bool finds_right) : rig_(rig), finds_right_(finds_right) {
    points_.assign(68, Eigen::Vector3d(0, 0, 600));  // Camera: the patient's right is -x, up is -y
    for (int i = 36; i < 42; ++i) points_[i] = {-32, -30, 605};
    for (int i = 42; i < 48; ++i) points_[i] = {32, -30, 605};
    for (int i = 48; i < 68; ++i) points_[i] = {0, 40, 600};
    points_[30] = {0, 0, 575};
  }
  std::optional<face::FaceLandmarks> detect(const cv::Mat& grey) const override {
    const bool is_left = grey.at<std::uint8_t>(0, 0) == 1;
    if (!is_left && !finds_right_) return std::nullopt;
    face::FaceLandmarks face;
    face.face = {200, 150, 180, 180};
    for (const auto& p : points_)
      face.points68.push_back(is_left ? cameras::project(rig_.left, p)
                                      : cameras::project(rig_.right, rig_.right_T_left.isometry() * p));
    return face;
  }
  std::optional<face::FaceLandmarks> detectNear(const cv::Mat& grey,
                                                const face::FaceLandmarks&) const override {
    return detect(grey);
  }
  std::optional<face::FaceLandmarks> detectAtRoll(const cv::Mat& grey, double) const override {
    return detect(grey);
  }
  std::vector<Eigen::Vector3d> points_;

 private:
  cameras::StereoRig rig_;
  bool finds_right_;
};

cameras::StereoRig vgaRig() {
  auto rig = session::fakes::rig();
  rig.width_px = 640, rig.height_px = 480;
  rig.left.k = rig.right.k = cv::Matx33d(800, 0, 320, 0, 800, 240, 0, 0, 1);
  return rig;
}

cameras::StereoFrame taggedFrame() {
  cameras::StereoFrame frame;
  frame.left = cv::Mat(480, 640, CV_8UC1, cv::Scalar(1));
  frame.right = cv::Mat(480, 640, CV_8UC1, cv::Scalar(2));
  return frame;
}

TEST(FindFace, GivesThePatientsAxesAndNoseInSpace) {
  const auto rig = vgaRig();
  const auto face = measured_face::findFace(rig, taggedFrame(), FakeDetector(rig, true));
  ASSERT_TRUE(face.start.patient_right && face.start.patient_superior && face.start.nose_tip);
  EXPECT_THAT(face.start.patient_right->v, ::facenav::testing::EigenNear(Eigen::Vector3d(-1, 0, 0), 1e-6));
  EXPECT_LT(face.start.patient_superior->v.y(), -0.99);
  EXPECT_THAT(face.start.nose_tip->mm, ::facenav::testing::EigenNear(Eigen::Vector3d(0, 0, 575), 0.01));
}

TEST(FindFace, GivesNoHintsFromOneImageAlone) {
  const auto rig = vgaRig();
  const auto face = measured_face::findFace(rig, taggedFrame(), FakeDetector(rig, false));
  EXPECT_TRUE(face.left);
  EXPECT_FALSE(face.right);
  EXPECT_FALSE(face.start.patient_right);
  EXPECT_FALSE(face.centre);
}

TEST(FindFace, RefusesEyesFartherApartThanAnyones) {
  const auto rig = vgaRig();
  FakeDetector detector(rig, true);
  for (int i = 42; i < 48; ++i) detector.points_[i].x() = 120;
  EXPECT_FALSE(measured_face::findFace(rig, taggedFrame(), detector).start.patient_right);
}

stereo::FaceCloud faceAndWall() {
  stereo::FaceCloud cloud;
  for (int i = 0; i < 1000; ++i) {
    const double x = (i % 40) * 4.0 - 80.0, y = (i / 40) * 6.0 - 75.0;
    cloud.cloud.points_mm.emplace_back(x, y, 590 + 0.002 * (x * x + y * y));  // face
    cloud.cloud.points_mm.emplace_back(3 * x, 3 * y, 1300);                   // wall
    for (int k = 0; k < 2; ++k) cloud.left_px.emplace_back(float(i), float(k));
  }
  return cloud;
}

TEST(CutFace, KeepsTheFaceAndLeavesTheWallWithOrWithoutLandmarks) {
  const auto cloud = faceAndWall();
  measured_face::FaceInSpace unknown, known;
  known.centre = Point<Camera>(0, 0, 600);
  for (const auto& face : {unknown, known}) {
    const auto cut = measured_face::cutFace(cloud, face);
    EXPECT_EQ(cut.cloud.size(), 1000u);
    ASSERT_EQ(cut.left_px.size(), cut.cloud.size());
    for (std::size_t i = 0; i < cut.cloud.size(); ++i) {
      EXPECT_LT(cut.cloud.points_mm[i].z(), 700);
      EXPECT_EQ(cut.left_px[i].y(), 0.f);  // each point keeps its own pixel
    }
  }
}

TEST(AlignFromCapture, RefusesAScanWithoutAFaceInWords) {
  surface::ScalpSurface scalp;
  scalp.has_face = false;
  scalp.findings = {"the face was removed below the brow"};
  const auto rig = vgaRig();
  const auto aligner = registration::makeSurfaceAligner();
  TaskMonitor monitor;
  try {
    alignFromCapture(rig, {taggedFrame(), taggedFrame()}, measured_face::AlignedFrom::dots,
                     {scalp, *aligner, FakeDetector(rig, true), {}}, monitor);
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("not aligned"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("the face was removed below the brow"), std::string::npos);
  }
}

TEST(AlignFromCapture, RefusesAnUnknownMatcherWithTheNamesKnown) {
  const auto rig = vgaRig();
  const auto aligner = registration::makeSurfaceAligner();
  TaskMonitor monitor;
  try {
    alignFromCapture(rig, {taggedFrame(), taggedFrame()}, measured_face::AlignedFrom::dots,
                     {{}, *aligner, FakeDetector(rig, true), {}, {}, "guess"}, monitor);
    FAIL();
  } catch (const Error& error) {
    const std::string words = error.what();
    EXPECT_NE(words.find("unknown dense matcher 'guess'"), std::string::npos) << words;
    EXPECT_NE(words.find("field, ssd, sgm"), std::string::npos) << words;
  }
}

/// Accepts any cloud that is large enough, and records its size.
class EasyAligner : public registration::Aligner {
 public:
  registration::AlignmentResult align(const registration::ScalpField&, const PointCloud<Camera>& face,
                                      const registration::AlignmentStart& start,
                                      TaskMonitor&) const override {
    was_guided = start.patient_right.has_value();
    if (face.size() < enough) throw Error(was_guided ? "too little where the landmarks are" : "too little");
    registration::AlignmentResult result;
    result.points = int(face.size());
    return result;
  }
  std::size_t enough = 5000;
  mutable bool was_guided = true;
};

class MisledAlignment : public ::testing::Test {
 protected:
  MisledAlignment() : rig(testing::convergingRig()), detector(rig, true) {
    for (auto& p : detector.points_) p.y() -= 330;  // for example, a face on a poster
    scalp.has_face = true;
    scalp.mesh = testing::ballMesh(80);
  }

  AlignmentOutcome align(const testing::Surface& surface,
                         const std::string& matcher = stereo::kDefaultMatcher) const {
    TaskMonitor monitor;
    const auto pattern = testing::Scene(surface, {}).render(rig);
    auto plain = taggedFrame();
    return alignFromCapture(rig, {pattern, plain}, measured_face::AlignedFrom::dots,
                            {scalp, aligner, detector, {}, {}, matcher}, monitor);
  }

  cameras::StereoRig rig;
  FakeDetector detector;
  EasyAligner aligner;
  surface::ScalpSurface scalp;
};

TEST_F(MisledAlignment, IsTriedOnceMoreWithoutTheLandmarks) {
  const auto outcome = align(testing::sphere({60, 0, 680}, 85));
  EXPECT_GT(outcome.result.points, 5000);
  EXPECT_FALSE(aligner.was_guided);
  EXPECT_FALSE(outcome.landmarks.left) << "the landmarks were wrong and are not kept";
}

TEST_F(MisledAlignment, IsMeasuredByTheMatcherAskedFor) {
  const auto surface = testing::sphere({60, 0, 680}, 85);
  const auto by_field = align(surface), by_ssd = align(surface, "ssd");
  EXPECT_FALSE(by_field.stored().matcher) << "the default is not written";
  EXPECT_EQ(by_ssd.stored().matcher, "ssd");
  EXPECT_GT(by_ssd.result.points, 5000);
  EXPECT_NE(by_ssd.result.points, by_field.result.points);
}

/// Grey skin with noise-free bright points at random in blocks of this size, like a projector's dots.
cv::Mat dotted(int block_px) {
  cv::Mat image(480, 640, CV_8U, cv::Scalar(90));
  unsigned random = 7;
  for (int y = 0; y + block_px <= image.rows; y += block_px)
    for (int x = 0; x + block_px <= image.cols; x += block_px) {
      random = random * 1664525u + 1013904223u;
      const int across = int(random >> 8) % (block_px - 1), down = int(random >> 20) % (block_px - 1);
      image(cv::Rect(x + across, y + down, 2, 2)) = 160;
    }
  return image;
}

TEST(SparseDots, AreToldFromDenseOnesAndFromNone) {
  const cv::Mat plain(480, 640, CV_8U, cv::Scalar(120));
  const auto pair = [&](const cv::Mat& pattern) {
    return capture::CapturePair{{pattern, pattern}, {plain, plain}};
  };
  EXPECT_TRUE(measured_face::areDotsSparse(pair(dotted(44))));
  EXPECT_FALSE(measured_face::areDotsSparse(pair(dotted(5))));
  EXPECT_FALSE(measured_face::areDotsSparse(pair(dotted(9))));
  EXPECT_FALSE(measured_face::areDotsSparse(pair(plain)));
}

TEST_F(MisledAlignment, SaysThatTheProjectorWasOff) {
  testing::SceneOptions off;
  off.dots_grey = 0;
  aligner.enough = 1000000;
  const auto pictures = testing::Scene(testing::sphere({60, 0, 680}, 85), off).render(rig);
  TaskMonitor monitor;
  try {
    alignFromCapture(rig, {pictures, pictures}, measured_face::AlignedFrom::dots,
                     {scalp, aligner, detector, {}}, monitor);
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("shows none, or too few (switch the projector on"),
              std::string::npos)
        << error.what();
  }
}

TEST_F(MisledAlignment, GivesTheFirstReasonWhereNothingIsFoundEither) {
  aligner.enough = 1000000;
  try {
    align(testing::sphere({60, 0, 680}, 85));
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("where the landmarks are"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace facenav::steps
