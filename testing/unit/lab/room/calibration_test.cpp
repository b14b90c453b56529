#include <gtest/gtest.h>

#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include "facenav/room/room_rig.h"
#include "photo_of_plate.h"

namespace facenav::room {
namespace {

constexpr int kColumns = 9, kRows = 6;
constexpr double kSquare_mm = 25.0;

std::vector<Eigen::Isometry3d> boardPoses() {
  std::vector<Eigen::Isometry3d> poses;
  for (int view = 0; view < 14; ++view) {
    const double a = 2 * M_PI * view / 14.0;
    poses.push_back(testing::platePose(
        {60.0 + 75.0 * std::cos(a), 5.0 + 45.0 * std::sin(a), 640.0 + 90.0 * std::cos(2.3 * a)},
        {0.45 * std::sin(1.7 * a), 0.45 * std::cos(2.1 * a), 0.25 * std::sin(3.0 * a)}));
  }
  return poses;
}

TEST(Chessboard, CalibratesBackToTheRig) {
  const auto rig = makeRig({});
  testing::PlatePhotographer photographer(rig, plateMesh(285, 210),
                                          makeChessboardLook(kColumns, kRows, kSquare_mm));
  std::vector<cv::Point3f> board;
  for (int row = 0; row < kRows; ++row)
    for (int column = 0; column < kColumns; ++column)
      board.emplace_back(float((column - 0.5 * (kColumns - 1)) * kSquare_mm),
                         float((row - 0.5 * (kRows - 1)) * kSquare_mm), 0.f);
  std::vector<std::vector<cv::Point3f>> objects;
  std::array<std::vector<std::vector<cv::Point2f>>, 2> found;
  for (const auto& pose : boardPoses()) {
    const auto images = photographer.photograph(pose, 1.0);
    std::array<std::vector<cv::Point2f>, 2> corners;
    bool is_whole = true;
    for (std::size_t side = 0; side < 2; ++side) {
      is_whole = is_whole && cv::findChessboardCorners(images[side], {kColumns, kRows}, corners[side]);
      if (is_whole)
        cv::cornerSubPix(images[side], corners[side], {5, 5}, {-1, -1},
                         {cv::TermCriteria::COUNT | cv::TermCriteria::EPS, 40, 1e-4});
    }
    if (!is_whole) continue;
    objects.push_back(board);
    for (std::size_t side = 0; side < 2; ++side) found[side].push_back(corners[side]);
  }
  ASSERT_GE(objects.size(), 10u);
  cv::Mat k1, d1, k2, d2, r, t, e, f;
  const cv::Size size(rig.width_px, rig.height_px);
  std::vector<cv::Mat> rotations, shifts;
  cv::calibrateCamera(objects, found[0], size, k1, d1, rotations, shifts, cv::CALIB_FIX_K3);
  cv::calibrateCamera(objects, found[1], size, k2, d2, rotations, shifts, cv::CALIB_FIX_K3);
  const double rms_px = cv::stereoCalibrate(objects, found[0], found[1], k1, d1, k2, d2, size, r, t, e, f,
                                            cv::CALIB_USE_INTRINSIC_GUESS | cv::CALIB_FIX_K3);
  EXPECT_LT(rms_px, 0.12);
  EXPECT_NEAR(k1.at<double>(0, 0), rig.left.k(0, 0), 2.0);
  EXPECT_NEAR(k2.at<double>(0, 0), rig.right.k(0, 0), 2.0);
  EXPECT_NEAR(k1.at<double>(0, 2), rig.left.k(0, 2), 2.0);
  EXPECT_NEAR(k1.at<double>(1, 2), rig.left.k(1, 2), 2.0);
  Eigen::Matrix3d rotation;
  for (int i = 0; i < 9; ++i) rotation(i / 3, i % 3) = r.at<double>(i / 3, i % 3);
  EXPECT_LT(rotationAngle(rotation.transpose() * rig.right_T_left.rotation()) * 180.0 / M_PI, 0.1);
  const Eigen::Vector3d shift_mm(t.at<double>(0), t.at<double>(1), t.at<double>(2));
  EXPECT_LT((shift_mm - rig.right_T_left.translation_mm()).norm(), 1.0);
}

}  // namespace
}  // namespace facenav::room
