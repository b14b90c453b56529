#include "facenav/cameras/calibrate.h"

#include <gmock/gmock.h>

#include <opencv2/imgproc.hpp>

#include "facenav/core/error.h"
#include "support/matchers.h"
#include "support/stereo_rigs.h"
#include "synthetic_boards.h"

using namespace facenav;
using namespace facenav::cameras;
using ::testing::HasSubstr;
namespace support = facenav::testing;

namespace {

Calibration calibrated(const std::vector<BoardView>& views) {
  TaskMonitor monitor;
  return calibrateCorners(views, {640, 480}, kBoard, monitor);
}

std::string messageOf(const std::vector<CalibrationPair>& pairs) {
  TaskMonitor monitor;
  try {
    calibrate(pairs, kBoard, monitor);
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace

TEST(Calibrate, RecoversTheRigFromCorners) {
  const StereoRig rig = support::convergingRig();
  const Calibration result = calibrated(syntheticViews(rig, 14, 0.1, 3));
  EXPECT_NEAR(result.rms_px, 0.1 * std::sqrt(2.0),
              0.012);  // 2-D distance for noise of 0.1 px along each axis
  EXPECT_EQ(result.usedViews(), 14);
  EXPECT_NEAR(result.rig.left.k(0, 0), rig.left.k(0, 0), 2.0);
  EXPECT_NEAR(result.rig.baseline_mm(), rig.baseline_mm(), 0.15);
  EXPECT_THAT(result.rig.right_T_left, support::PoseNear(rig.right_T_left, 0.1, 0.8));
  EXPECT_GT(result.held_out_rms_px, result.rms_px * 0.95);
  // The relevant error: depth of a point 600 mm away, projected by the true rig and measured with the
  // calibrated one.
  const Eigen::Vector3d p(20, -30, 600);
  const Eigen::Vector3d measured =
      triangulate(result.rig, project(rig.left, p), project(rig.right, rig.right_T_left.isometry() * p)).mm;
  EXPECT_NEAR(measured.norm(), p.norm(), 1.0);
}

TEST(Calibrate, NamesAndDropsAViewInWhichTheBoardMoved) {
  const StereoRig rig = support::convergingRig();
  auto views = syntheticViews(rig, 12, 0.1, 5);
  for (auto& corner : views[4].right) corner += cv::Point2f(1.5f, 2.5f);
  const Calibration result = calibrated(views);
  EXPECT_EQ(result.usedViews(), 11);
  EXPECT_FALSE(result.views[4].is_used);
  EXPECT_THAT(result.views[4].reason, HasSubstr("disagrees"));
  EXPECT_THAT(result.views[4].reason, HasSubstr("not simultaneous"));
  EXPECT_GT(result.views[4].right_rms_px.value(), 0.5);
  EXPECT_NEAR(result.rms_px, 0.1 * std::sqrt(2.0), 0.015);
}

TEST(Calibrate, NamesViewsWhoseExposuresWereNotSimultaneous) {
  const auto views = laggingViews(support::convergingRig(), 14, {2, 5, 9}, 2.0, 11);
  const Calibration result = calibrated(views);
  EXPECT_EQ(result.usedViews(), 11);
  for (const int i : {2, 5, 9}) {
    EXPECT_FALSE(result.views[std::size_t(i)].is_used);
    EXPECT_THAT(result.views[std::size_t(i)].reason, HasSubstr("not simultaneous, the board moved"));
  }
  EXPECT_THAT(result.warnings, ::testing::Contains(HasSubstr("between the two exposures in 3 of 14 views")));
  EXPECT_THAT(result.warnings, ::testing::Each(::testing::Not(HasSubstr("angles"))));
}

TEST(Calibrate, TellsBadCornersFromAMovedBoard) {
  auto views = syntheticViews(support::convergingRig(), 12, 0.1, 13);
  for (std::size_t i = 0; i < 20; ++i) views[3].left[i] += cv::Point2f(2.0f, -1.0f);  // a few rows only
  const Calibration result = calibrated(views);
  EXPECT_EQ(result.usedViews(), 11);
  EXPECT_THAT(result.views[3].reason, HasSubstr("corners of the left image are off"));
  EXPECT_THAT(result.warnings, ::testing::Each(::testing::Not(HasSubstr("exposures"))));
}

TEST(Calibrate, RefusesACameraThatLags) {
  const auto views = laggingViews(support::convergingRig(), 10, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9}, 3.0, 17);
  try {
    calibrated(views);
    FAIL() << "a rig was made of views of a lagging camera";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("moved between the two exposures"));
    EXPECT_THAT(error.what(), HasSubstr("trigger both cameras"));
  }
}

TEST(Calibrate, RefusesWhereFewerThanEightViewsStoodStill) {
  const auto views = laggingViews(support::convergingRig(), 12, {1, 3, 6, 8, 10}, 3.0, 11);
  try {
    calibrated(views);
    FAIL() << "a rig was made of 7 views";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("the cameras were not triggered together"));
    EXPECT_THAT(error.what(), HasSubstr("in 5 of 12 views"));
    EXPECT_THAT(error.what(), HasSubstr("7 views are left and 8 are needed"));
    EXPECT_THAT(error.what(), HasSubstr("trigger both cameras together"));
  }
}

TEST(Calibrate, AsksForAnglesOnlyWhereTheyLack) {
  const auto flat = syntheticViews(support::convergingRig(), 10, 0.1, 19, 0.1);
  EXPECT_THAT(calibrated(flat).warnings, ::testing::Contains(HasSubstr("more angles")));
  const auto turned = syntheticViews(support::convergingRig(), 10, 0.1, 19);
  EXPECT_THAT(calibrated(turned).warnings, ::testing::Each(::testing::Not(HasSubstr("angles"))));
}

TEST(Calibrate, StandardErrorsCoverTheTruth) {
  StereoRig rig = support::convergingRig();
  rig.left.distortion = support::distortion({-0.21, 0.11, 0.0007, -0.0004});
  rig.right.distortion = support::distortion({-0.19, 0.08, -0.0003, 0.0006});
  double squares = 0;
  int count = 0, beyond_two = 0;
  for (unsigned seed = 21; seed < 27; ++seed) {
    const Calibration result = calibrated(syntheticViews(rig, 9, 0.1, seed));
    ASSERT_EQ(result.model, "k1 k2 p1 p2");
    const std::vector<double> truth = {rig.left.k(0, 0),
                                       rig.left.k(1, 1),
                                       rig.left.k(0, 2),
                                       rig.left.k(1, 2),
                                       -0.21,
                                       0.11,
                                       0.0007,
                                       -0.0004,
                                       rig.right.k(0, 0),
                                       rig.right.k(1, 1),
                                       rig.right.k(0, 2),
                                       rig.right.k(1, 2),
                                       -0.19,
                                       0.08,
                                       -0.0003,
                                       0.0006};
    for (std::size_t i = 0; i < truth.size(); ++i) {
      const double z = (result.parameters[i].value - truth[i]) / result.parameters[i].sigma;
      squares += z * z;
      beyond_two += std::abs(z) > 2;
      ++count;
    }
    EXPECT_LT(result.at_head.length_mm, 0.5);
    EXPECT_GT(result.at_head.length_mm, 0.0);
  }
  EXPECT_LT(std::sqrt(squares / count), 1.3);
  EXPECT_GT(std::sqrt(squares / count), 0.4);  // the given errors are not many times too large either
  EXPECT_LT(double(beyond_two) / count, 0.1);
}

TEST(Calibrate, TakesAFullerModelOnlyWhereViewsLeftOutGainByIt) {
  const auto simple = calibrated(syntheticViews(support::convergingRig(), 14, 0.1, 7));
  EXPECT_EQ(simple.model, "k1 k2 p1 p2");
  StereoRig strong = support::convergingRig();
  strong.left.distortion = strong.right.distortion = support::distortion({-0.35, 0.35, 0, 0, -0.9});
  const auto fuller = calibrated(syntheticViews(strong, 20, 0.02, 7));
  EXPECT_NE(fuller.model, "k1 k2 p1 p2");
  EXPECT_EQ(fuller.models.size(), 4u);
  for (const auto& model : fuller.models) EXPECT_GT(model.held_out_rms_px, 0);
}

TEST(Calibrate, TangentialTermsStayWhereTheLensHasThem) {
  StereoRig rig = support::convergingRig();
  rig.left.distortion = rig.right.distortion = support::distortion({-0.2, 0.1, 0.003, -0.003});
  EXPECT_EQ(calibrated(syntheticViews(rig, 14, 0.1, 7)).model, "k1 k2 p1 p2");
  rig.left.distortion = rig.right.distortion = support::distortion({-0.2, 0.1, 0, 0});
  const Calibration centred = calibrated(syntheticViews(rig, 14, 0.1, 7));
  EXPECT_EQ(centred.model, "k1 k2");
  EXPECT_EQ(centred.rig.left.distortion.at<double>(2), 0);
  EXPECT_NEAR(centred.rig.left.distortion.at<double>(0), -0.2, 0.02);
  EXPECT_LT(centred.rms_px, 0.15);
}

TEST(Calibrate, WarnsOfSwappedSides) {
  auto views = syntheticViews(support::convergingRig(), 10, 0.05, 9);
  for (auto& view : views) std::swap(view.left, view.right);
  const Calibration result = calibrated(views);
  EXPECT_THAT(result.warnings, ::testing::Contains(HasSubstr("swapped")));
}

TEST(Calibrate, PicturesOfOneCameraForBothSidesAreRefused) {
  auto views = syntheticViews(support::convergingRig(), 10, 0.05, 9);
  for (auto& view : views) view.right = view.left;
  try {
    calibrated(views);
    ADD_FAILURE() << "a rig without a distance between its cameras";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("left and right are pictures of the same camera"));
  }
}

TEST(Calibrate, RefusesTooLittle) {
  EXPECT_THAT(messageOf({}), HasSubstr("no image pairs"));
  const cv::Mat grey(480, 640, CV_8U, cv::Scalar(128)), small(240, 320, CV_8U, cv::Scalar(128));
  EXPECT_THAT(messageOf({{"a", grey, grey}, {"b", grey, grey}}), HasSubstr("found in none of the 2 pairs"));
  EXPECT_THAT(messageOf({{"a", grey, grey}, {"b", small, grey}}), HasSubstr("320 x 240"));
}

TEST(Chessboard, TextOfABoard) {
  EXPECT_EQ(boardFromText("9x6", 25).columns, 9);
  EXPECT_EQ(boardFromText("9x6", 25).rows, 6);
  for (const char* text : {"", "9", "9x", "x6", "9x6x", "9.5x6", "2x6", "-9x6", "9 x 6"})
    EXPECT_THROW(boardFromText(text, 25), Error) << text;
  for (const double square_mm : {0.0, -25.0, 0.025, 25000.0, double(NAN)})
    EXPECT_THROW(boardFromText("9x6", square_mm), Error) << square_mm;
}

TEST(Chessboard, CornersOfADrawnBoardAreFoundInOneOrder) {
  const Board board{7, 4, 10};  // 8 x 5 squares of 40 px; the first one is black
  cv::Mat image(400, 560, CV_8U, cv::Scalar(230));
  for (int r = 0; r < 5; ++r)
    for (int c = 0; c < 8; ++c)
      if ((r + c) % 2 == 0)
        cv::rectangle(image, cv::Rect(100 + 40 * c, 100 + 40 * r, 40, 40), cv::Scalar(20), -1);
  cv::GaussianBlur(image, image, {}, 1.0);
  const auto corners = findCorners(image, board);
  ASSERT_EQ(corners.size(), 28u);
  // Square edges lie between pixels: corner (0, 0) of the board at 139.5, 139.5.
  EXPECT_NEAR(corners[0].x, 139.5, 0.05);
  EXPECT_NEAR(corners[0].y, 139.5, 0.05);
  EXPECT_NEAR(corners[27].x, 139.5 + 6 * 40, 0.05);
  cv::Mat turned;
  cv::rotate(image, turned, cv::ROTATE_180);
  const auto turned_corners = findCorners(turned, board);
  ASSERT_EQ(turned_corners.size(), 28u);
  EXPECT_NEAR(turned_corners[0].x, 559 - 139.5, 0.05);
  EXPECT_NEAR(turned_corners[0].y, 399 - 139.5, 0.05);
}
