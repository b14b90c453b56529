// The live surface beside a coil, on a rendered portrait whose shape and pose are known exactly. The coil is
// not in the picture: only its outline is excluded from the measurement.

#include "facenav/monitoring/surface_beside_coil.h"

#include <gtest/gtest.h>

#include "facenav/core/robust_statistics.h"
#include "sitting.h"

namespace facenav::monitoring {
namespace {

using namespace sitting;

const std::vector<Eigen::Vector2d> kOutline{{-12, -12}, {12, -12}, {12, 12}, {-12, 12}};

/// Coil with its contact face before the face's middle, its axis along the cameras' view.
RigidTransform<Camera, Coil> coilAt(const Eigen::Vector3d& p_mm) {
  return {Eigen::Quaterniond::Identity(), p_mm};
}

RigidTransform<Camera, Mri> asPose(const Eigen::Isometry3d& pose) {
  return RigidTransform<Camera, Mri>::fromIsometry(pose);
}

BesideCoilFinding measureAt(const SyntheticView& view, const Eigen::Isometry3d& pose) {
  const auto& sitting = Sitting::shared();
  const SurfaceBesideCoil beside(sitting.rig(), sitting.scalp(), kOutline);
  const Eigen::Vector3d before_mm = view.motion * (sitting.centre_mm() - Eigen::Vector3d(0, 0, 25));
  return beside.measure(sitting.render(view), asPose(pose), coilAt(before_mm));
}

TEST(SurfaceBesideCoil, LiesOnTheSkinWhereTheHeadIsTrackedRight) {
  if (!hasPortrait()) GTEST_SKIP() << "python3-skimage's portrait is not installed";
  std::uint64_t seed = 40;
  for (const auto& turn_deg : {Eigen::Vector3d(0, 0, 0), {3, 12, 2}, {-4, -10, 5}}) {
    SyntheticView view;
    view.motion = Sitting::shared().about(turn_deg, {4, -3, 10});
    view.seed = ++seed;
    const auto found = measureAt(view, view.motion);
    ASSERT_TRUE(found.has_measured) << found.unseen;
    EXPECT_LT(std::abs(found.above_skin_mm), 2 * found.sigma_mm) << turn_deg.transpose();
    EXPECT_LT(found.sigma_mm, 1.0);
    EXPECT_GT(found.points, 1000);
  }
}

/// Median cosine between the view and the normal of skin that faces the cameras, in a square around the
/// middle.
double usualFacing() {
  std::vector<double> facing;
  const auto& skin = Sitting::shared().scalp()->skin().points;
  for (std::size_t i = 0; i < skin.size(); ++i) {
    const Eigen::Vector2d off_mm = (skin.points_mm[i] - Sitting::shared().centre_mm()).head<2>().cwiseAbs();
    const double away_mm = off_mm.maxCoeff() - 12;
    if (away_mm > SurfaceBesideCoil::kNearest_mm && away_mm < SurfaceBesideCoil::kFarthest_mm &&
        -skin.normals[i].z() > 0.45)
      facing.push_back(-skin.normals[i].z());
  }
  return median(facing);
}

TEST(SurfaceBesideCoil, SeesByHowMuchTheHeadIsTrackedTooNearOrTooFar) {
  if (!hasPortrait()) GTEST_SKIP() << "python3-skimage's portrait is not installed";
  SyntheticView view;
  view.motion = Sitting::shared().about({0, 0, 0}, {0, 0, 0});
  view.seed = 44;
  const double right_mm = measureAt(view, view.motion).above_skin_mm;
  for (const double off_mm : {-3.0, 3.0}) {
    const auto found = measureAt(view, Sitting::shared().about({0, 0, 0}, {0, 0, off_mm}) * view.motion);
    ASSERT_TRUE(found.has_measured) << found.unseen;
    // If the head is tracked too far away, the true surface lies outside its skin, by the shift's part along
    // the skin's normal.
    EXPECT_NEAR(found.above_skin_mm - right_mm, off_mm * usualFacing(), 0.25);
  }
}

TEST(SurfaceBesideCoil, SaysWhyNothingIsSeen) {
  if (!hasPortrait()) GTEST_SKIP() << "python3-skimage's portrait is not installed";
  const auto& sitting = Sitting::shared();
  const SurfaceBesideCoil beside(sitting.rig(), sitting.scalp(), kOutline);
  SyntheticView view;
  auto frame = sitting.render(view);
  const auto away =
      beside.measure(frame, asPose(view.motion), coilAt(sitting.centre_mm() + Eigen::Vector3d(300, 0, 0)));
  EXPECT_FALSE(away.has_measured);
  EXPECT_EQ(away.unseen, "no skin beside the coil faces both cameras");
  frame.left.setTo(90);
  frame.right.setTo(90);
  const auto flat =
      beside.measure(frame, asPose(view.motion), coilAt(sitting.centre_mm() - Eigen::Vector3d(0, 0, 25)));
  EXPECT_FALSE(flat.has_measured);
  EXPECT_FALSE(flat.unseen.empty());
}

std::shared_ptr<const cameras::StereoFrame> emptyFrame(double captured_s) {
  auto frame = std::make_shared<cameras::StereoFrame>();
  frame->captured = {captured_s};
  return frame;
}

TEST(BesideCoilWatch, AFindingHoldsForSecondsAndWhileTheCoilStaysThere) {
  int asked = 0;
  BesideCoilWatch watch(
      [&](const BesideCoilWatch::Question&) {
        ++asked;
        BesideCoilFinding finding;
        finding.has_measured = true;
        finding.above_skin_mm = asked;
        return finding;
      },
      BesideCoilWatch::Mode::in_line);
  const RigidTransform<Camera, Mri> head(Eigen::Quaterniond::Identity(), {0, 0, 600});
  const auto at = [&](double s, double x_mm, bool has_head = true) {
    watch.add(emptyFrame(s), has_head ? std::optional(head) : std::nullopt, coilAt({x_mm, 0, 500}));
  };
  at(0.0, 0);
  EXPECT_FALSE(watch.finding()) << "no answer yet";
  at(0.2, 0);
  ASSERT_TRUE(watch.finding());
  EXPECT_EQ(watch.finding()->above_skin_mm, 1);
  at(0.4, 12);
  EXPECT_FALSE(watch.finding()) << "the coil is elsewhere";
  at(0.6, 8);
  EXPECT_TRUE(watch.finding());
  at(0.8, 8, false);
  EXPECT_FALSE(watch.finding()) << "the head is lost";
  EXPECT_EQ(asked, 1) << "once a second";
  at(1.1, 8);
  at(1.3, 8);
  EXPECT_EQ(asked, 2);
  EXPECT_EQ(watch.finding()->above_skin_mm, 2);
}

}  // namespace
}  // namespace facenav::monitoring
