// A portrait on a head-like surface of known shape, without dots: errors of the measured face, from one frame
// and from several.

#include "facenav/measured_face/measured_face.h"

#include <gmock/gmock.h>

#include <random>

#include "facenav/core/error.h"
#include "facenav/geometry/rotation.h"
#include "facenav/measured_face/face_in_space.h"
#include "support/stereo_rigs.h"
#include "support/synthetic_face.h"
#include "support/test_data.h"

namespace facenav::steps {
namespace {

using facenav::testing::SyntheticFace;
using facenav::testing::SyntheticView;
using ::testing::HasSubstr;

/// Film of a head that sways by some millimetres and degrees; one frame may be occluded.
class SwayingFilm : public capture::FrameSource {
 public:
  SwayingFilm(const SyntheticFace& face, const cameras::StereoRig& rig, int frames, int hidden = -1,
              std::uint64_t seed = 1)
      : face_(face), rig_(rig), frames_(frames), hidden_(hidden), seed_(seed) {}
  const cameras::StereoRig& rig() const override { return rig_; }
  std::shared_ptr<const cameras::StereoFrame> next() override {
    if (number_ >= frames_) return nullptr;
    auto frame = std::make_shared<cameras::StereoFrame>(face_.render(rig_, viewAt(number_)));
    frame->number = number_++;
    return frame;
  }
  SyntheticView viewAt(int number) const {
    SyntheticView view;
    view.noise_grey = 3.0;
    view.seed = seed_ + std::uint64_t(number);
    view.time_s = number / 30.0;
    const double phase = 0.5 * number;
    view.motion = Eigen::Translation3d(2 * std::sin(phase), std::cos(phase) - 1, 640 + std::sin(phase)) *
                  Eigen::AngleAxisd(0.03 * std::sin(phase), Eigen::Vector3d::UnitY()) *
                  Eigen::Translation3d(0, 0, -640);
    if (number == hidden_) view.cover_mm = cv::Rect2d(-200, -200, 400, 400);
    return view;
  }

 private:
  const SyntheticFace& face_;
  cameras::StereoRig rig_;
  int frames_, hidden_, number_ = 0;
  std::uint64_t seed_;
};

struct Errors {
  int points = 0;
  // Shares within 1 and 2 given standard errors.
  double median_mm = 0, rms_mm = 0, within = 0, within_two = 0;
};

class MeasuredFaces : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(SyntheticFace::portraitPath()))
      GTEST_SKIP() << "no portrait (python3-skimage)";
    static const SyntheticFace shared = SyntheticFace::astronaut();
    face_ = &shared;
    detector_ = face::makeFaceDetector();
    if (truth_.empty()) makeTruth();
  }

  /// Distance of the skin along the ray of every second pixel; 0: no skin.
  void makeTruth() {
    const auto reference = face_->reference(rig_, true);
    truth_ = cv::Mat::zeros(rig_.height_px, rig_.width_px, CV_64F);
    for (std::size_t i = 0; i < reference.surface.size(); ++i)
      truth_.at<double>(int(reference.surface_left_px[i].y()), int(reference.surface_left_px[i].x())) =
          reference.surface.points_mm[i].norm();
  }

  /// Returns false at the outline, where stereo mixes face and background.
  static bool isInner(const Eigen::Vector3d& p_mm) {
    return (p_mm.head<2>() - Eigen::Vector2d(0, -10)).norm() < 55;
  }

  /// Errors of the inner face, compared with the truth along the ray.
  Errors errorsOf(const stereo::FusedCloud& cloud) const {
    Errors errors;
    std::vector<double> off_mm;
    for (std::size_t i = 0; i < cloud.face.cloud.size(); ++i) {
      const int x = int(std::lround(cloud.face.left_px[i].x())),
                y = int(std::lround(cloud.face.left_px[i].y()));
      const Eigen::Vector3d& p = cloud.face.cloud.points_mm[i];
      if (!isInner(p)) continue;
      if (x % 2 || y % 2 || truth_.at<double>(y, x) == 0) continue;
      const double off = std::abs(p.norm() - truth_.at<double>(y, x));
      off_mm.push_back(off);
      errors.rms_mm += off * off;
      errors.within += off <= cloud.face.sigma_mm[i];
      errors.within_two += off <= 2 * cloud.face.sigma_mm[i];
    }
    if (off_mm.empty()) return errors;
    errors.points = int(off_mm.size());
    errors.rms_mm = std::sqrt(errors.rms_mm / errors.points);
    errors.within /= errors.points, errors.within_two /= errors.points;
    std::nth_element(off_mm.begin(), off_mm.begin() + errors.points / 2, off_mm.end());
    errors.median_mm = off_mm[std::size_t(errors.points / 2)];
    std::printf("%d points: median %.3f mm, rms %.3f mm, %.0f %% within one, %.0f %% within two deviations\n",
                errors.points, errors.median_mm, errors.rms_mm, 100 * errors.within, 100 * errors.within_two);
    return errors;
  }

  measured_face::MeasuredFace filmed(int frames, int hidden = -1, std::uint64_t seed = 1) const {
    SwayingFilm film(*face_, rig_, frames, hidden, seed);
    const auto tracker = head_tracking::makeModelHeadTracker(detector_);
    TaskMonitor monitor;
    return measured_face::measureFilm(
        film, 0, frames - 1, head_tracking::motionSinceFirst(*tracker, film.rig()), *detector_, monitor);
  }

  /// Difference of two clouds of one inner face: rms along the rays that both have, without the largest 5 %.
  double differenceOf(const stereo::FusedCloud& a, const stereo::FusedCloud& b) const {
    cv::Mat distance = cv::Mat::zeros(rig_.height_px, rig_.width_px, CV_64F);
    const auto at = [&](const stereo::FusedCloud& cloud, std::size_t i) -> double& {
      const auto& px = cloud.face.left_px[i];
      return distance.at<double>(int(std::lround(px.y())), int(std::lround(px.x())));
    };
    for (std::size_t i = 0; i < a.face.cloud.size(); ++i) at(a, i) = a.face.cloud.points_mm[i].norm();
    std::vector<double> squares;
    for (std::size_t i = 0; i < b.face.cloud.size(); ++i)
      if (isInner(b.face.cloud.points_mm[i]) && at(b, i) > 0)
        squares.push_back(std::pow(b.face.cloud.points_mm[i].norm() - at(b, i), 2));
    EXPECT_GT(squares.size(), 10000u);
    std::sort(squares.begin(), squares.end());
    squares.resize(squares.size() * 19 / 20);
    double sum = 0;
    for (const double square : squares) sum += square;
    return std::sqrt(sum / double(squares.size()));
  }

  void expectWithinStatedDeviation(const measured_face::MeasuredFace& face) const {
    const Errors errors = errorsOf(face.cloud);
    EXPECT_GT(errors.points, 3000);
    EXPECT_LT(errors.median_mm, 0.5);
    EXPECT_GT(errors.within, 0.6);
    EXPECT_GT(errors.within_two, 0.85);
  }

  const cameras::StereoRig rig_ = facenav::testing::faceRig();
  const SyntheticFace* face_ = nullptr;
  std::shared_ptr<const face::FaceDetector> detector_;
  static inline cv::Mat truth_;
};

TEST_F(MeasuredFaces, PlainSkinIsMeasuredWithinItsStatedDeviation) {
  SwayingFilm film(*face_, rig_, 1);
  const auto frame = film.next();
  TaskMonitor monitor;
  const measured_face::MeasuredFace face =
      measured_face::measurePair(rig_, *frame, *frame, false, *detector_, monitor);
  ASSERT_EQ(face.cloud.frames.size(), face.cloud.face.cloud.size());
  expectWithinStatedDeviation(face);
}

TEST_F(MeasuredFaces, SeveralFramesSayHowManyTheyAreAndHowFarTheyMayBeOff) {
  const measured_face::MeasuredFace many = filmed(10, 5);
  EXPECT_EQ(many.fused, 9);
  EXPECT_EQ(many.lost, 1);
  expectWithinStatedDeviation(many);
}

/// Compares two films of the same motion with different noise.
TEST_F(MeasuredFaces, SeveralFramesAreLessNoisyThanOne) {
  const double one_mm = differenceOf(filmed(1, -1, 1).cloud, filmed(1, -1, 101).cloud);
  const double many_mm = differenceOf(filmed(9, -1, 1).cloud, filmed(9, -1, 101).cloud);
  std::printf("noise of one frame %.3f mm, of nine %.3f mm\n", one_mm, many_mm);
  EXPECT_LT(many_mm, 0.6 * one_mm);
}

TEST_F(MeasuredFaces, AFilmWithoutTheFrameIsRefused) {
  SwayingFilm film(*face_, rig_, 2);
  const auto tracker = head_tracking::makeModelHeadTracker(detector_);
  TaskMonitor monitor;
  try {
    measured_face::measureFilm(film, 7, 9, head_tracking::motionSinceFirst(*tracker, film.rig()), *detector_,
                               monitor);
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("no frame 7"));
  }
}

/// Landmarks of a face that looks at the cameras, each off by a pixel or so.
class NoisyLandmarks : public face::FaceDetector {
 public:
  NoisyLandmarks(const cameras::StereoRig& rig, double depth_mm, double noise_px)
      : rig_(rig), off_(0, noise_px) {
    std::mt19937_64 random(3);
    for (auto* points : {&left_, &right_})
      for (int i = 0; i < 68; ++i) {
        const int row = i < 17 ? 3 : i < 27 ? -5 : i < 36 ? 0 : i < 48 ? -3 : 4;
        const double x = i < 36 ? 8.0 * (i % 9 - 4) : i < 42 ? -32.0 : i < 48 ? 32.0 : 4.0 * (i % 10 - 5);
        const Eigen::Vector3d p(x, 12.0 * row, depth_mm - (i == 30 ? 25 : 0));
        points->push_back((points == &left_
                               ? cameras::project(rig_.left, p)
                               : cameras::project(rig_.right, rig_.right_T_left.isometry() * p)) +
                          Eigen::Vector2d(off_(random), off_(random)));
      }
  }
  std::optional<face::FaceLandmarks> detect(const cv::Mat& grey) const override {
    face::FaceLandmarks found;
    found.face = {100, 100, 110, 110};
    found.points68 = grey.at<std::uint8_t>(0, 0) == 1 ? left_ : right_;
    return found;
  }
  std::optional<face::FaceLandmarks> detectNear(const cv::Mat& grey,
                                                const face::FaceLandmarks&) const override {
    return detect(grey);
  }
  std::optional<face::FaceLandmarks> detectAtRoll(const cv::Mat& grey, double) const override {
    return detect(grey);
  }

 private:
  const cameras::StereoRig& rig_;
  std::normal_distribution<double> off_;
  std::vector<Eigen::Vector2d> left_, right_;
};

TEST(FaceInSpace, AFarFaceWhoseLandmarksScatterInDepthStillGivesTheStart) {
  const auto rig = testing::convergingRig();
  cameras::StereoFrame pair;
  pair.left = cv::Mat(8, 8, CV_8U, cv::Scalar(1)), pair.right = cv::Mat(8, 8, CV_8U, cv::Scalar(2));
  const double depth_mm = 1400, px = 1.2;  // a pixel of disparity is some 20 mm there
  const auto face = measured_face::findFace(rig, pair, NoisyLandmarks(rig, depth_mm, px));
  ASSERT_TRUE(face.centre && face.start.patient_right && face.start.nose_tip);
  EXPECT_NEAR(face.centre->mm.z(), depth_mm, 15);
  EXPECT_GT(face.start.patient_right->v.dot(-Eigen::Vector3d::UnitX()), std::cos(20 * kRadPerDeg));
  EXPECT_GT(face.start.patient_superior->v.normalized().dot(-Eigen::Vector3d::UnitY()),
            std::cos(20 * kRadPerDeg));
}

}  // namespace
}  // namespace facenav::steps
