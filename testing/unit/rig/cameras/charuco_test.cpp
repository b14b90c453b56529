#include <gtest/gtest.h>

#include <opencv2/aruco/charuco.hpp>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>
#include <random>

#include "facenav/cameras/calibrate.h"
#include "facenav/cameras/marker_dictionary.h"
#include "facenav/core/error.h"
#include "facenav/geometry/rotation.h"
#include "support/stereo_rigs.h"

namespace facenav::cameras {
namespace {

const Board kBoard = [] {
  Board board = boardFromText("charuco:8x6", 28.0, 21.0);
  board.dictionary = "5x5_100";
  return board;
}();
constexpr int kPrint_px_by_square = 60;

/// Print as OpenCV draws it, one square 60 px.
const cv::Mat& print() {
  static const cv::Mat image = [] {
    const auto dictionary = cv::aruco::getPredefinedDictionary(predefinedDictionary(kBoard.dictionary));
    const auto board = cv::aruco::CharucoBoard::create(8, 6, 28.f, 21.f, dictionary);
    cv::Mat drawn;
    board->draw({8 * kPrint_px_by_square, 6 * kPrint_px_by_square}, drawn, 0, 1);
    return drawn;
  }();
  return image;
}

/// Photograph of the print at `view_T_print` (origin: the print's top left corner, x right, y down). The
/// print is blurred to the view's resolution, then sampled at every pixel's centre.
cv::Mat photograph(const CameraModel& camera, const Eigen::Isometry3d& view_T_print, unsigned seed) {
  constexpr int kStep = 8;  // the map is smooth: every eighth pixel is computed
  const Eigen::Isometry3d print_T_view = view_T_print.inverse();
  cv::Mat_<cv::Vec2f> coarse(480 / kStep + 2, 640 / kStep + 2), map(480, 640);
  const auto onPrint = [&](double x, double y) {
    const Eigen::Vector3d ray = print_T_view.linear() * undistort(camera, {x, y}).homogeneous();
    const Eigen::Vector3d eye = print_T_view.translation(), hit = eye - ray * (eye.z() / ray.z());
    return cv::Vec2f(float(hit.x() / 28.0 * kPrint_px_by_square - 0.5),
                     float(hit.y() / 28.0 * kPrint_px_by_square - 0.5));
  };
  for (int y = 0; y < coarse.rows; ++y)
    for (int x = 0; x < coarse.cols; ++x) coarse(y, x) = onPrint(x * kStep, y * kStep);
  for (int y = 0; y < 480; ++y)
    for (int x = 0; x < 640; ++x) {
      const int i = x / kStep, j = y / kStep;
      const float fx = float(x % kStep) / kStep, fy = float(y % kStep) / kStep;
      map(y, x) = (1 - fy) * ((1 - fx) * coarse(j, i) + fx * coarse(j, i + 1)) +
                  fy * ((1 - fx) * coarse(j + 1, i) + fx * coarse(j + 1, i + 1));
    }
  cv::Mat soft, paper, image;
  cv::copyMakeBorder(print(), paper, 40, 40, 40, 40, cv::BORDER_CONSTANT, cv::Scalar(255));
  cv::GaussianBlur(paper, soft, {}, 1.6);
  soft.convertTo(soft, CV_8U, 0.7, 25);
  cv::remap(soft, image, map + cv::Scalar(40, 40), cv::noArray(), cv::INTER_CUBIC, cv::BORDER_CONSTANT,
            cv::Scalar(110));
  cv::Mat noise(image.size(), CV_16S), noisy;
  cv::RNG random(seed);
  random.fill(noise, cv::RNG::NORMAL, 0, 1.5);
  cv::add(image, noise, noisy, cv::noArray(), CV_8U);
  return noisy;
}

/// Photographs of boards before the rig. Every third is so near, or so far to the side, that it is cut off.
std::vector<CalibrationPair> photographs(const StereoRig& rig, int count) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> unit(-1, 1);
  std::vector<CalibrationPair> pairs;
  for (int i = 0; i < count; ++i) {
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.linear() = expRotation({0.5 * unit(random), 0.5 * unit(random), 0.3 * unit(random)});
    const double aside = i % 3 == 0 ? 1.6 : 0.5;
    pose.translation() = Eigen::Vector3d(60 + 80 * aside * unit(random), 60 * aside * unit(random),
                                         (i % 3 == 0 ? 380 : 520) + 60 * unit(random)) -
                         pose.linear() * Eigen::Vector3d(112, 84, 0);
    pairs.push_back({"pair " + std::to_string(i), photograph(rig.left, pose, 2 * i + 1),
                     photograph(rig.right, rig.right_T_left.isometry() * pose, 2 * i + 2)});
  }
  return pairs;
}

TEST(Charuco, CornersOfAWholeBoardFitItsPose) {
  const auto rig = facenav::testing::convergingRig();
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = expRotation({0.2, -0.3, 0.1});
  pose.translation() = Eigen::Vector3d(10, 0, 560) - pose.linear() * Eigen::Vector3d(112, 84, 0);
  const SeenCorners seen = findBoard(photograph(rig.left, pose, 1), kBoard);
  ASSERT_EQ(int(seen.px.size()), kBoard.corners());
  // Relative to the best-fitting pose, because OpenCV draws its print about a pixel off.
  cv::Vec3d rotation, translation;
  const auto points = boardPoints(kBoard, seen.ids);
  cv::solvePnP(points, seen.px, rig.left.k, rig.left.distortion, rotation, translation);
  std::vector<cv::Point2f> expected;
  cv::projectPoints(points, rotation, translation, rig.left.k, rig.left.distortion, expected);
  double squares = 0;
  for (std::size_t i = 0; i < expected.size(); ++i)
    squares += std::pow(cv::norm(expected[i] - seen.px[i]), 2);
  EXPECT_LT(std::sqrt(squares / double(expected.size())), 0.12);
}

TEST(Charuco, PartlySeenBoardsCalibrateBackToTheRig) {
  const auto rig = facenav::testing::convergingRig();
  TaskMonitor monitor;
  const Calibration result = calibrate(photographs(rig, 15), kBoard, monitor);
  int used = 0;
  for (const auto& view : result.views) used += view.is_used;
  EXPECT_GE(used, 10);
  EXPECT_LT(result.rms_px, 0.2);
  EXPECT_LT(result.held_out_rms_px, 0.25);
  EXPECT_NEAR(result.rig.baseline_mm(), rig.baseline_mm(), 0.4);
  const Eigen::Vector3d p(20, -30, 560);
  const Eigen::Vector3d measured =
      triangulate(result.rig, project(rig.left, p), project(rig.right, rig.right_T_left.isometry() * p)).mm;
  EXPECT_NEAR(measured.norm(), p.norm(), 1.5);
  // The standard errors are correct: the truth lies within four of them.
  for (const auto& parameter : result.parameters) {
    EXPECT_GT(parameter.sigma, 0) << parameter.name;
    if (parameter.name == "left fx px") {
      EXPECT_NEAR(parameter.value, rig.left.k(0, 0), 4 * parameter.sigma + 0.5);
    }
  }
}

TEST(Charuco, TextOfABoard) {
  EXPECT_TRUE(kBoard.isCharuco());
  EXPECT_EQ(kBoard.columns, 7);
  EXPECT_EQ(kBoard.rows, 5);
  EXPECT_DOUBLE_EQ(boardFromText("charuco:7x5", 30).marker_mm.value(), 22.5);
  EXPECT_FALSE(boardFromText("9x6", 30).isCharuco());
  EXPECT_THROW(boardFromText("charuco:7x5", 30, 31), Error);
  EXPECT_THROW(boardFromText("charuco:7x5", 30, 0), Error);
  EXPECT_THROW(boardFromText("charuco:3x3", 30), Error);
  Board unknown = kBoard;
  unknown.dictionary = "4x4_51";
  EXPECT_THROW(findBoard(cv::Mat(100, 100, CV_8U, cv::Scalar(0)), unknown), Error);
}

TEST(Charuco, NoBoardNoCorners) {
  EXPECT_TRUE(findBoard(cv::Mat(480, 640, CV_8U, cv::Scalar(120)), kBoard).px.empty());
}

}  // namespace
}  // namespace facenav::cameras
