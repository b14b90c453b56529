// Windows of skin (skin_points.h), the pose fitted to them (skin_field.h) and the comparison of the two sides
// (sides.h).

#include <algorithm>
#include <functional>

#include "facenav/face/stereo_face.h"
#include "facenav/geometry/normal_equations.h"
#include "head_scene.h"
#include "recovery/sides.h"
#include "recovery/skin_field.h"
#include "recovery/skin_points.h"

namespace facenav::head_tracking::testing {
namespace {

using Eigen::Isometry3d;

class Skin : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    rig_ = std::make_unique<cameras::StereoRig>(facenav::testing::faceRig());
    const HeadReference reference = SyntheticFace::astronaut().reference(*rig_, true);
    const auto face = face::findStereoFace(*detector(), *rig_, reference.frame);
    ASSERT_TRUE(face);
    const FaceRegion region(face->left, reference.frame.left.size());
    const FaceSurface surface = measureSurface(*rig_, reference, region, face::depthOf(*rig_, *face));
    points_ = std::make_unique<SkinPoints>(*rig_, reference.frame, region, surface, SkinMobility(face->left));
  }
  static void TearDownTestSuite() { points_.reset(), rig_.reset(); }

  // Matches of windows of the reference in its own images, searched near the face at `predicted`.
  static std::vector<SkinMatch> foundFrom(const Isometry3d& predicted) {
    const SkinView& reference = points_->reference();
    return points_->find(reference, *rig_, reference.pictures, predicted, {0, 6, 1});
  }

  // True position of the point in a camera's image.
  static Eigen::Vector2d placeOf(const SkinMatch& match) {
    const Eigen::Vector3d& p_mm = (*points_)[std::size_t(match.point)].mm;
    return match.camera == 0 ? cameras::project(rig_->left, p_mm)
                             : cameras::project(rig_->right, rig_->right_T_left.isometry() * p_mm);
  }

  static std::unique_ptr<cameras::StereoRig> rig_;
  static std::unique_ptr<SkinPoints> points_;
};

std::unique_ptr<cameras::StereoRig> Skin::rig_;
std::unique_ptr<SkinPoints> Skin::points_;

// Median distance to each point's true position. The parabola through the best correlation has an error of
// some hundredths of a pixel; rounding to whole pixels, some tenths.
double medianError_px(const std::vector<SkinMatch>& matches,
                      const std::function<Eigen::Vector2d(const SkinMatch&)>& place) {
  std::vector<double> errors_px;
  for (const auto& match : matches) errors_px.push_back((match.px - place(match)).norm());
  std::sort(errors_px.begin(), errors_px.end());
  return errors_px[errors_px.size() / 2];
}

TEST_F(Skin, OfAFaceThatHasNotMovedIsFoundInItsPlace) {
  const auto matches = foundFrom(Isometry3d::Identity());
  ASSERT_GT(matches.size(), 200u);
  EXPECT_LT(medianError_px(matches, placeOf), 0.08);
  const EpipolarOffset lines = epipolarOffset(*rig_, matches);
  EXPECT_LT(std::abs(lines.median_px), 0.01);
  EXPECT_LT(lines.spread_px, 0.05);
}

TEST_F(Skin, IsFoundInItsPlaceFromAPredictionThatIsOff) {
  for (const double off_mm : {0.35, -0.8, 1.3}) {
    const auto matches = foundFrom(Isometry3d(Eigen::Translation3d(off_mm, -0.7 * off_mm, 0)));
    ASSERT_GT(matches.size(), 200u);
    EXPECT_LT(medianError_px(matches, placeOf), 0.15) << off_mm;
  }
}

// Cheeks and hair, a quarter of all windows, move up by 3 mm together while the head moves.
TEST_F(Skin, ThatMovesAsOnePieceDoesNotTakeThePoseAlong) {
  auto matches = foundFrom(Isometry3d::Identity());
  Vector6d truth;
  truth << 0.004, -0.006, 0.003, 0.6, -0.4, 0.8;
  cv::RNG random(5);
  for (auto& match : matches) {
    const SkinPoint& point = (*points_)[std::size_t(match.point)];
    const bool is_moved = point.part >= 10;
    const Eigen::Vector3d skin_mm(0, is_moved ? -3.0 : 0.0, 0);
    match.offset_px = match.jacobian * truth + match.jacobian.rightCols<3>() * skin_mm +
                      Eigen::Vector2d(random.gaussian(0.2), random.gaussian(0.2));
  }
  const auto pose = solveWithSkinField(*points_, matches);
  ASSERT_TRUE(pose);
  const Vector6d off = pose->xi - truth;
  const Eigen::Vector3d behind_mm(0, 0, 80);
  const Eigen::Vector3d off_mm = off.head<3>().cross(behind_mm) + off.tail<3>();
  EXPECT_LT(off_mm.norm(), 0.3);
  EXPECT_LT(off.dot(solveSymmetric(pose->covariance, off)), 22.5) << "99.9 % of 6 degrees of freedom";
}

TEST_F(Skin, OfNoMatchGivesNoPose) { EXPECT_FALSE(solveWithSkinField(*points_, {})); }

TEST(StepWatch, NeedsTwoAnswersForASmallOffsetAndOneForALargeOne) {
  const auto offset = [](double median_px) { return EpipolarOffset{400, median_px, 0.4, 0.2}; };
  StepWatch watch;
  EXPECT_EQ(watch.judge(offset(0.05), 0, Timestamp{1.0}), StepVerdict::in_step);
  EXPECT_EQ(watch.judge(offset(0.27), 0, Timestamp{1.1}), StepVerdict::unsure);
  EXPECT_EQ(watch.judge(offset(0.27), 0, Timestamp{1.2}), StepVerdict::out_of_step);
  EXPECT_EQ(watch.judge(offset(-0.27), 0, Timestamp{1.3}), StepVerdict::unsure) << "the other way";
  EXPECT_EQ(watch.judge(offset(0.9), 0, Timestamp{9.0}), StepVerdict::out_of_step);
  EXPECT_EQ(watch.judge(offset(0.27), 0, Timestamp{19.0}), StepVerdict::unsure) << "too long ago";
  EXPECT_EQ(watch.judge(offset(0.27), 0.5, Timestamp{19.1}), StepVerdict::in_step) << "the head moves";
}

}  // namespace
}  // namespace facenav::head_tracking::testing
