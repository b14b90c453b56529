// Effects of real faces and cameras that a plain rendering lacks: grimaces, gloss, compression.
#include <gtest/gtest.h>

#include <set>

#include "patient/expression.h"
#include "patient/face_shape.h"
#include "played_scenario.h"
#include "script/script.h"
#include "support/matchers.h"

namespace facenav::room {
namespace {

/// The 68 points used by grimaces, at an adult's positions, on a face towards +y.
std::vector<Eigen::Vector3d> adultLandmarks() {
  std::vector<Eigen::Vector3d> l(68, Eigen::Vector3d(0.0, 60.0, -40.0));
  l[8] = {0, 85, -110};
  l[19] = {28, 88, 22}, l[24] = {-28, 88, 22};
  l[27] = {0, 92, 10}, l[28] = {0, 98, 0}, l[29] = {0, 104, -10};
  l[31] = {14, 94, -28}, l[35] = {-14, 94, -28};
  l[38] = {28, 80, 13}, l[43] = {-28, 80, 13};
  l[41] = {32, 80, 3}, l[46] = {-32, 80, 3};
  l[48] = {25, 88, -62}, l[54] = {-25, 88, -62};
  l[51] = {0, 98, -56}, l[57] = {0, 96, -70};
  l[62] = {0, 95, -61}, l[66] = {0, 95, -63};
  return l;
}

std::vector<Expression> grimaces() {
  std::vector<Expression> all(5);
  all[0].smile = all[1].tongue = all[2].lips_in = all[3].cheeks = all[4].brows = 1.0;
  return all;
}

double moved_mm(const Expression& expression, const Eigen::Vector3d& p_mm) {
  return expressionShift_mm(expression, p_mm, Eigen::Vector3d::UnitY(), adultLandmarks()).norm();
}

TEST(Expression, MovesTheMouthByMillimetresAndLeavesTheBridgeOfTheNose) {
  const auto l = adultLandmarks();
  for (const Expression& expression : grimaces()) {
    double mouth_mm = 0.0;
    for (const std::size_t point : {48, 51, 54, 57})
      mouth_mm = std::max(mouth_mm, moved_mm(expression, l[point]));
    if (expression.brows == 0.0) {
      EXPECT_GT(mouth_mm, 2.5);
    }
    EXPECT_LT(mouth_mm, 10.5);
    for (const std::size_t point : {27, 28, 29}) EXPECT_LT(moved_mm(expression, l[point]), 0.05);
    for (const double side : {-1.0, 1.0})
      EXPECT_LT(moved_mm(expression, {68.0 * side, 30.0, 15.0}), 0.1) << "temple";
  }
}

TEST(Expression, RaisesTheBrowsByAFewMillimetres) {
  const auto l = adultLandmarks();
  Expression expression;
  expression.brows = 1.0;
  for (const std::size_t point : {19, 24}) {
    EXPECT_GT(moved_mm(expression, l[point]), 1.0);
    EXPECT_LT(moved_mm(expression, l[point]), 3.5);
  }
}

TEST(Expression, NoneMovesNothing) { EXPECT_EQ(moved_mm({}, adultLandmarks()[51]), 0.0); }

TEST(FaceShape, AGrimaceMovesTextureWithTheSkinAndGoesWithoutTrace) {
  VirtualPatient patient = *testing::eggPatient();
  patient.landmarks68_mm = adultLandmarks();
  FaceShape face(patient);
  Expression smile;
  smile.smile = 1.0;
  ASSERT_TRUE(face.set(0.0, 0.0, smile));
  EXPECT_FALSE(face.isAtRest());
  EXPECT_FALSE(face.set(0.0, 0.0, smile)) << "nothing new";
  int moved = 0;
  for (std::size_t t = 0; t < patient.visible.triangles.size(); ++t) {
    const auto corner = std::size_t(patient.visible.triangles[t][0]);
    const Eigen::Vector3d shift_mm = face.vertices_mm()[corner] - patient.visible.vertices_mm[corner];
    EXPECT_LT((shift_mm - face.shift_mm(int(t), 0.f, 0.f)).norm(), 1e-9);
    moved += shift_mm.norm() > 1.0;
  }
  EXPECT_GT(moved, 10);
  ASSERT_TRUE(face.set(0.0, 0.0));
  EXPECT_TRUE(face.isAtRest());
  for (std::size_t i = 0; i < patient.visible.vertices_mm.size(); ++i)
    EXPECT_EQ(face.vertices_mm()[i], patient.visible.vertices_mm[i]);
}

double difference(const cv::Mat& a, const cv::Mat& b) { return cv::norm(a, b, cv::NORM_INF); }

TEST(Compression, ChangesPixelsAndNotTheTruth) {
  auto coarse = testing::smallScenario("free_motion", 2);
  coarse.jpeg_quality = 40;
  const auto plain = testing::playedToEnd(testing::smallScenario("free_motion", 2)),
             squeezed = testing::playedToEnd(coarse);
  EXPECT_GT(difference(plain.frames[1].left, squeezed.frames[1].left), 3.0);
  EXPECT_GT(difference(plain.frames[1].right, squeezed.frames[1].right), 3.0);
  EXPECT_EQ(plain.truths[1].camera_T_mri.matrix(), squeezed.truths[1].camera_T_mri.matrix());
  EXPECT_EQ(plain.truths[1].must_be_lost, squeezed.truths[1].must_be_lost);
}

TEST(CameraOptions, NeutralValuesAreTheDefaultsBitForBit) {
  auto neutral = testing::smallScenario("treatment", 1);
  neutral.jpeg_quality = 0;
  neutral.gloss = 0.0;
  neutral.haze_grey = 0.0;
  neutral.right_gain = neutral.right_gamma = 1.0;
  const auto a = testing::playedToEnd(testing::smallScenario("treatment", 1)),
             b = testing::playedToEnd(neutral);
  EXPECT_EQ(difference(a.frames[0].left, b.frames[0].left), 0.0);
  EXPECT_EQ(difference(a.frames[0].right, b.frames[0].right), 0.0);
}

TEST(CameraOptions, HazeLiftsBothCamerasAndTheRightOnesResponseIsItsOwn) {
  auto options = testing::smallScenario("still", 1);
  options.noise_grey = 0.0;
  const auto plain = testing::playedToEnd(options);
  options.haze_grey = 20.0;
  options.right_gain = 0.8;
  const auto hazy = testing::playedToEnd(options);
  const double left = cv::mean(hazy.frames[0].left)[0] - cv::mean(plain.frames[0].left)[0];
  EXPECT_NEAR(left, 20.0, 1.0);
  EXPECT_NEAR(cv::mean(hazy.frames[0].right)[0], 0.8 * cv::mean(plain.frames[0].right)[0] + 20.0, 1.0);
}

/// Light that gloss adds to one image of the egg, and its centre (px from the image's left).
struct Added {
  double grey = 0.0, column = 0.0;
};
Added addedBy(const cv::Mat& glossy, const cv::Mat& plain) {
  cv::Mat more;
  cv::subtract(glossy, plain, more, {}, CV_32F);
  Added added;
  for (int y = 0; y < more.rows; ++y)
    for (int x = 0; x < more.cols; ++x) {
      added.grey += more.at<float>(y, x);
      added.column += more.at<float>(y, x) * x;
    }
  added.column /= added.grey;
  return added;
}

TEST(Gloss, LiesElsewhereOnTheSkinForEachCamera) {
  auto options = testing::smallScenario("still", 1);
  options.noise_grey = 0.0;
  const auto plain = testing::playedToEnd(options);
  options.gloss = 1.0;
  const auto glossy = testing::playedToEnd(options);
  const Added left = addedBy(glossy.frames[0].left, plain.frames[0].left),
              right = addedBy(glossy.frames[0].right, plain.frames[0].right);
  EXPECT_GT(left.grey, 500.0);
  EXPECT_GT(right.grey, 500.0);
  // A pattern painted on the skin would shift by the parallax of the face. A highlight shifts by less, since
  // the mirrored lamp is behind the surface.
  const SyntheticSource source(options, testing::eggPatient());
  const auto camera_T_mri = glossy.truths[0].camera_T_mri;
  const Eigen::Vector3d face = (camera_T_mri * testing::eggPatient()->face_middle).mm;
  const auto& rig = source.rig();
  const double parallax = cameras::project(rig.left, face).x() -
                          cameras::project(rig.right, rig.right_T_left.isometry() * face).x();
  EXPECT_GT(std::abs(left.column - right.column - parallax), 1.5);
}

TEST(Grimace, ComesBackFourTimesElsewhereAfterMoreThanASecond) {
  auto options = testing::smallScenario("grimace");
  const auto a = testing::playedToEnd(options);
  ASSERT_EQ(a.frames.size(), 78u);
  std::set<std::string> labels;
  int returns = 0;
  double seen_s = 0.0;
  for (std::size_t i = 0; i < a.frames.size(); ++i) {
    labels.insert(a.truths[i].label);
    const bool is_away = a.truths[i].label == "away";
    EXPECT_EQ(a.truths[i].must_be_lost, is_away) << i;
    if (i > 0) {
      EXPECT_GT(a.frames[i].captured.s, a.frames[i - 1].captured.s);
    }
    if (is_away) continue;
    if (i > 0 && a.frames[i].captured.s - seen_s > 1.0) {
      ++returns;
      const auto since = a.truths[i].camera_T_mri.isometry() * a.truths[0].camera_T_mri.isometry().inverse();
      const double turn_deg = rotationAngle(since.linear()) * 180.0 / M_PI;
      EXPECT_GT(turn_deg, 0.3);
      EXPECT_LT(turn_deg, 6.5);
    }
    seen_s = a.frames[i].captured.s;
  }
  EXPECT_EQ(returns, 4);
  EXPECT_EQ(labels.size(), 6u) << "at rest, away, four grimaces";
}

TEST(Grimace, SameSeedSameFrames) {
  const auto a = testing::playedToEnd(testing::smallScenario("grimace", 14)),
             b = testing::playedToEnd(testing::smallScenario("grimace", 14));
  EXPECT_EQ(difference(a.frames.back().left, b.frames.back().left), 0.0);
  EXPECT_EQ(difference(a.frames.back().right, b.frames.back().right), 0.0);
}

TEST(GrimaceOther, PutsAnotherPersonThereAtTheSecondReturnOnly) {
  const auto shown = testing::playedToEnd(testing::smallScenario("grimace_other"));
  for (std::size_t i = 0; i < shown.truths.size(); ++i)
    EXPECT_EQ(shown.truths[i].is_patient_there, i < 27 || i >= 44) << i;
}

TEST(Returns, PatientComesBackThreeTimesTurnedAndInOtherLight) {
  const auto options = testing::smallScenario("returns");
  const auto patient = testing::eggPatient();
  const auto script = makeScript(options, *patient, leftHandArea(*patient), {});
  const auto seat = script->at(0).cast;
  std::set<std::string> grimaces;
  for (int frame = 0; frame < script->frameCount(); ++frame) {
    const Moment now = script->at(frame);
    if (now.label.rfind("back: ", 0) != 0) continue;
    grimaces.insert(now.label);
    const Eigen::Matrix3d since = now.cast.room_T_mri.rotation() * seat.room_T_mri.rotation().transpose();
    const double turn_deg = rotationAngle(since) * 180.0 / M_PI;
    EXPECT_GT(turn_deg, 3.0) << frame;  // 5 to 15 deg, plus the sway of a seated head
    EXPECT_LT(turn_deg, 17.0) << frame;
    EXPECT_NE(now.cast.lamp_scale, 1.0) << frame;
    EXPECT_GT(now.cast.lamp_shift_mm.norm(), 199.0) << frame;
    EXPECT_FALSE(now.cast.expression.isNone()) << frame;
  }
  EXPECT_EQ(grimaces.size(), 3u);
}

TEST(Returns, TheHeadIsOutOfThePicturesBetweenTwoVisits) {
  const auto shown = testing::playedToEnd(testing::smallScenario("returns", 48));
  EXPECT_FALSE(shown.truths[0].must_be_lost);
  EXPECT_TRUE(shown.truths[30].must_be_lost && shown.truths[31].must_be_lost);
  EXPECT_FALSE(shown.truths[47].must_be_lost);
  EXPECT_GT(shown.frames[31].captured.s - shown.frames[30].captured.s, 1.0);
}

TEST(OutOfStep, HeadMovedByThreeToTenMillimetresBetweenTheCameras) {
  const auto options = testing::smallScenario("out_of_step");
  const auto patient = testing::eggPatient();
  const auto script = makeScript(options, *patient, leftHandArea(*patient), {});
  for (int frame = 0; frame < script->frameCount(); ++frame) {
    const Moment now = script->at(frame);
    EXPECT_EQ(now.right_behind != 0.0, frame >= 24) << frame;
    if (now.right_behind == 0.0) continue;
    const auto before = script->at(frame - now.right_behind).cast.room_T_mri;
    const double apart_mm =
        ((now.cast.room_T_mri * patient->face_middle).mm - (before * patient->face_middle).mm).norm();
    EXPECT_GT(apart_mm, 3.0) << frame;
    EXPECT_LT(apart_mm, 10.0) << frame;
  }
  const auto shown = testing::playedToEnd(testing::smallScenario("out_of_step", 26));
  EXPECT_FALSE(shown.truths[23].is_out_of_step);
  EXPECT_TRUE(shown.truths[25].is_out_of_step && shown.truths[25].must_be_lost);
}

}  // namespace
}  // namespace facenav::room
