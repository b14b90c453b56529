// Pivot and jig calibration at their limits: exact data, too little turn, points in a line, outliers, sides.

#include <gtest/gtest.h>

#include <random>

#include "facenav/coil_tracking/coil_calibration.h"
#include "facenav/core/error.h"
#include "facenav/geometry/rotation.h"
#include "support/matchers.h"

namespace facenav::coil_tracking {
namespace {

using facenav::testing::EigenNear;
using facenav::testing::PoseNear;
using Poses = std::vector<RigidTransform<Camera, Marker>>;

const Eigen::Vector3d kTip_mm(30, -20, 550), kPoint_mm(5, -70, 12);

/// Poses of the marker turned by these rotation vectors (rad) while kPoint_mm of its frame stays on the tip.
Poses pivoting(const std::vector<Eigen::Vector3d>& turns) {
  Poses poses;
  for (const auto& turn : turns) {
    const Eigen::Matrix3d r = expRotation(turn);
    poses.push_back({Eigen::Quaterniond(r), kTip_mm - r * kPoint_mm});
  }
  return poses;
}

std::vector<Eigen::Vector3d> cone(int count, double first_rad, double second_rad) {
  std::vector<Eigen::Vector3d> turns;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * M_PI * i / count;
    turns.emplace_back(first_rad * std::cos(angle), second_rad * std::sin(angle), 0.1 * std::sin(3 * angle));
  }
  return turns;
}

TEST(Pivot, OfExactPosesIsExact) {
  const auto pivot = fitPivot(pivoting(cone(40, 0.5, 0.5)));
  EXPECT_THAT(pivot.in_marker_mm, EigenNear(kPoint_mm, 1e-6));
  EXPECT_LT(pivot.rms_mm, 1e-6);
  EXPECT_LT(pivot.covariance.trace(), 1e-9);
  EXPECT_EQ(pivot.poses, 40);
  EXPECT_EQ(pivot.used, 40);
}

TEST(Pivot, DoesNotDependOnWhereTheTipStands) {
  auto poses = pivoting(cone(30, 0.5, 0.4));
  for (auto& pose : poses)
    pose = RigidTransform<Camera, Camera>(Eigen::Quaterniond(expRotation({0.4, 1, -0.3})), {100, 50, -80}) *
           pose;
  EXPECT_THAT(fitPivot(poses).in_marker_mm, EigenNear(kPoint_mm, 1e-6));
}

TEST(Pivot, ATurnAboutOneAxisOnlyIsRefused) {
  EXPECT_THROW(fitPivot(pivoting(cone(40, 0.6, 0.0))), Error)
      << "the point could lie anywhere along that axis";
  EXPECT_THROW(fitPivot(pivoting(cone(40, 0.0, 0.0))), Error);
  EXPECT_NO_THROW(fitPivot(pivoting(cone(40, 0.6, 0.6))));
}

TEST(Pivot, NeedsTenPoses) {
  EXPECT_THROW(fitPivot({}), Error);
  EXPECT_THROW(fitPivot(pivoting(cone(9, 0.5, 0.5))), Error);
  EXPECT_NO_THROW(fitPivot(pivoting(cone(10, 0.5, 0.5))));
}

TEST(Pivot, FramesThatSlippedAreLeftOut) {
  auto poses = pivoting(cone(60, 0.5, 0.5));
  for (const int i : {3, 17, 40})
    poses[std::size_t(i)] =
        RigidTransform<Camera, Camera>(Eigen::Quaterniond::Identity(), {8, -6, 5}) * poses[std::size_t(i)];
  const auto pivot = fitPivot(poses);
  EXPECT_EQ(pivot.used, 57);
  EXPECT_EQ(pivot.poses, 60);
  EXPECT_THAT(pivot.in_marker_mm, EigenNear(kPoint_mm, 1e-6));
}

TEST(Pivot, ItsStatedErrorCoversTheTrueOne) {
  double squares = 0, stated = 0;
  for (unsigned seed = 1; seed <= 60; ++seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal(0, 0.2);
    auto poses = pivoting(cone(50, 0.45, 0.45));
    for (auto& pose : poses)
      pose = RigidTransform<Camera, Camera>(Eigen::Quaterniond::Identity(),
                                            {normal(random), normal(random), normal(random)}) *
             pose;
    const auto pivot = fitPivot(poses);
    squares += (pivot.in_marker_mm - kPoint_mm).squaredNorm() / 60;
    stated += pivot.covariance.trace() / 60;
    EXPECT_NEAR(pivot.rms_mm, 0.2 * std::sqrt(3.0), 0.1);
  }
  EXPECT_GT(stated, squares) << "frames count as one in four, so the stated error is larger for free noise";
  EXPECT_LT(stated, 9 * squares);
}

Pivot at(const Eigen::Vector3d& point_mm) {
  Pivot pivot;
  pivot.in_marker_mm = point_mm;
  pivot.covariance = 0.01 * Eigen::Matrix3d::Identity();
  pivot.poses = pivot.used = 20;
  return pivot;
}

TEST(ThreePivots, GiveTheAxesOfTheFormat) {
  const auto coil = calibrateWithPivots(at({10, 20, 30}), at({10, -70, 30}), at({60, 35, 30}));
  EXPECT_THAT(coil.marker_T_coil.translation_mm(), EigenNear(Eigen::Vector3d(10, 20, 30), 1e-9));
  EXPECT_THAT(coil.marker_T_coil.rotation().col(1), EigenNear(Eigen::Vector3d(0, 1, 0), 1e-9))
      << "from the handle";
  EXPECT_THAT(coil.marker_T_coil.rotation().col(0), EigenNear(Eigen::Vector3d(1, 0, 0), 1e-9))
      << "to the side";
  EXPECT_NEAR(coil.marker_T_coil.rotation().determinant(), 1.0, 1e-9);
  EXPECT_NEAR(coil.sigma_mm, std::sqrt(0.03), 1e-9);
  EXPECT_EQ(coil.frames, 60);
}

TEST(ThreePivots, TheOtherSideTurnsTheCoilOver) {
  const auto coil = calibrateWithPivots(at({0, 0, 0}), at({0, -90, 0}), at({60, 0, 0})),
             other = calibrateWithPivots(at({0, 0, 0}), at({0, -90, 0}), at({-60, 0, 0}));
  EXPECT_THAT(coil.marker_T_coil.rotation().col(2), EigenNear(Eigen::Vector3d(0, 0, 1), 1e-9));
  EXPECT_THAT(other.marker_T_coil.rotation().col(2), EigenNear(Eigen::Vector3d(0, 0, -1), 1e-9));
}

TEST(ThreePivots, TooNearOrInOneLineAreRefused) {
  EXPECT_THROW(calibrateWithPivots(at({0, 0, 0}), at({0, -19.9, 0}), at({60, 0, 0})), Error);
  EXPECT_NO_THROW(calibrateWithPivots(at({0, 0, 0}), at({0, -20.1, 0}), at({60, 0, 0})));
  EXPECT_THROW(calibrateWithPivots(at({0, 0, 0}), at({0, -90, 0}), at({19.9, 0, 0})), Error);
  EXPECT_THROW(calibrateWithPivots(at({0, 0, 0}), at({0, -90, 0}), at({0, 90, 0})), Error) << "in one line";
  EXPECT_THROW(calibrateWithPivots(at({0, 0, 0}), at({0, 0, 0}), at({60, 0, 0})), Error) << "the same point";
}

TEST(ThreePivots, LongerArmsAreSurerOfTheDirection) {
  const auto sigma_deg = [&](double arm_mm) {
    return calibrateWithPivots(at({0, 0, 0}), at({0, -arm_mm, 0}), at({arm_mm, 0, 0})).sigma_deg;
  };
  EXPECT_NEAR(sigma_deg(50) / sigma_deg(100), 2.0, 1e-9);
}

RigidTransform<Marker, Coil> mount() {
  return {Eigen::Quaterniond(expRotation({0.2, -0.5, 0.3})), {10, -40, 55}};
}

std::vector<JigObservation> jigFrames(int count, const RigidTransform<Coil, Marker>& coil_T_jig) {
  std::vector<JigObservation> frames;
  for (int i = 0; i < count; ++i) {
    const RigidTransform<Camera, Coil> coil(Eigen::Quaterniond(expRotation({0.1 * i, 0.3, -0.05 * i})),
                                            {5.0 * i, 20, 600});
    frames.push_back({coil * mount().inverse(), coil * coil_T_jig});
  }
  return frames;
}

TEST(Jig, OfExactPosesIsExactAndNeedsFiveFrames) {
  const RigidTransform<Coil, Marker> coil_T_jig(Eigen::Quaterniond(expRotation({0, 0.4, 1})), {70, 5, 10});
  EXPECT_THROW(calibrateWithJig(jigFrames(4, coil_T_jig), coil_T_jig), Error);
  EXPECT_THROW(calibrateWithJig({}, coil_T_jig), Error);
  const auto result = calibrateWithJig(jigFrames(5, coil_T_jig), coil_T_jig);
  EXPECT_THAT(result.marker_T_coil, PoseNear(mount(), 1e-6, 1e-6));
  EXPECT_LT(result.rms_mm, 1e-9);
  EXPECT_EQ(result.used, 5);
}

TEST(Jig, AFrameWhoseJigIsTurnedOrWhoseMarkerIsShiftedIsLeftOut) {
  const RigidTransform<Coil, Marker> coil_T_jig(Eigen::Quaterniond(expRotation({0, 0.4, 1})), {70, 5, 10});
  const RigidTransform<Marker, Marker> quarter(Eigen::Quaterniond(expRotation({0, 0, M_PI / 2})), {0, 0, 0});
  const RigidTransform<Camera, Camera> shift(Eigen::Quaterniond::Identity(), {0, 0, 15});
  auto turned = jigFrames(12, coil_T_jig), shifted = turned;
  turned[2].camera_T_jig = turned[2].camera_T_jig * quarter;
  shifted[8].camera_T_marker = shift * shifted[8].camera_T_marker;
  for (const auto& frames : {turned, shifted}) {
    const auto result = calibrateWithJig(frames, coil_T_jig);
    EXPECT_EQ(result.used, 11);
    EXPECT_EQ(result.frames, 12);
    EXPECT_THAT(result.marker_T_coil, PoseNear(mount(), 1e-6, 1e-6));
  }
}

/// The turned frame must not widen the limit for the shifted one.
TEST(Jig, ATurnedAndAShiftedFrameAreBothLeftOut) {
  const RigidTransform<Coil, Marker> coil_T_jig(Eigen::Quaterniond(expRotation({0, 0.4, 1})), {70, 5, 10});
  const RigidTransform<Marker, Marker> quarter(Eigen::Quaterniond(expRotation({0, 0, M_PI / 2})), {0, 0, 0});
  const RigidTransform<Camera, Camera> shift(Eigen::Quaterniond::Identity(), {0, 0, 15});
  auto frames = jigFrames(12, coil_T_jig);
  frames[2].camera_T_jig = frames[2].camera_T_jig * quarter;
  frames[8].camera_T_marker = shift * frames[8].camera_T_marker;
  const auto result = calibrateWithJig(frames, coil_T_jig);
  EXPECT_EQ(result.used, 10);
  EXPECT_THAT(result.marker_T_coil, PoseNear(mount(), 1e-6, 1e-6));
}

TEST(Jig, AThirdOfTheFramesTurnedAlikeAreLeftOut) {
  const RigidTransform<Coil, Marker> coil_T_jig(Eigen::Quaterniond(expRotation({0, 0.4, 1})), {70, 5, 10});
  const RigidTransform<Marker, Marker> flipped(Eigen::Quaterniond(expRotation({0.4, 0, 0})), {0, 0, 0});
  auto frames = jigFrames(12, coil_T_jig);
  for (const std::size_t i : {1u, 4u, 7u, 10u}) frames[i].camera_T_jig = frames[i].camera_T_jig * flipped;
  const auto result = calibrateWithJig(frames, coil_T_jig);
  EXPECT_EQ(result.used, 8);
  EXPECT_THAT(result.marker_T_coil, PoseNear(mount(), 1e-6, 1e-6));
}

}  // namespace
}  // namespace facenav::coil_tracking
