#include "facenav/health/rig_monitor.h"

#include <gtest/gtest.h>

#include <random>

#include "facenav/cameras/patch_match.h"
#include "facenav/geometry/rotation.h"
#include "facenav/health/rig_health.h"
#include "support/stereo_rigs.h"

namespace facenav::health {

using namespace cameras;
namespace {

StereoRig moved(const StereoRig& rig, const Eigen::Vector3d& turn_deg, const Eigen::Vector3d& shift_mm) {
  StereoRig other = rig;
  Eigen::Isometry3d pose = rig.right_T_left.isometry();
  pose.prerotate(expRotation(turn_deg * kRadPerDeg));
  pose.pretranslate(shift_mm);
  other.right_T_left = RigidTransform<RightCamera, Camera>::fromIsometry(pose);
  return other;
}

/// Skin and a coil's marker in the true rig, with 0.15 px and 0.03 px of noise, over some frames.
class Scene {
 public:
  Scene(const StereoRig& truth, unsigned seed) : truth_(truth), random_(seed) {}

  std::vector<Correspondence> face(int count) {
    std::vector<Correspondence> points;
    const Eigen::Vector3d middle_mm = middle(620);
    while (int(points.size()) < count) {
      const Eigen::Vector3d p_mm =
          middle_mm + Eigen::Vector3d(uniform(-70, 70), uniform(-90, 90), uniform(-40, 40));
      points.push_back({left(p_mm, 0.15), right(p_mm, 0.15), 0.2});
    }
    return points;
  }
  /// Adds wrong matches as in a real pair: every tenth is off by pixels, all in one corner of the face where
  /// a silhouette passes.
  std::vector<Correspondence> faceWithWrongMatches(int count) {
    std::vector<Correspondence> points = face(count);
    const double corner_px = project(truth_.left, middle(620) + Eigen::Vector3d(40, 0, 0)).x();
    for (auto& point : points)
      if (uniform(0, 1) < 0.1 || (point.left_px.x() > corner_px && uniform(0, 1) < 0.6))
        point.right_px.y() += uniform(-4, 4);
    return points;
  }
  SquareObservation marker(double size_mm, double depth_mm) {
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.linear() = expRotation({uniform(-0.5, 0.5), uniform(-0.5, 0.5), uniform(-3, 3)});
    pose.translation() = middle(depth_mm) + Eigen::Vector3d(uniform(-90, 90), uniform(-60, 60), 0);
    SquareObservation square;
    const double h = size_mm / 2;
    for (int i = 0; i < 4; ++i) {
      const Eigen::Vector3d p_mm = pose * Eigen::Vector3d(i == 1 || i == 2 ? h : -h, i < 2 ? -h : h, 0);
      square.left_px[i] = left(p_mm, 0.03);
      square.right_px[i] = right(p_mm, 0.03);
    }
    square.size_mm = 60.0;
    square.print_sigma_mm = 0.1;
    square.size_sigma_mm = 0.03;
    return square;
  }

 private:
  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  Eigen::Vector2d noise(double sigma_px) {
    std::normal_distribution<double> normal(0, sigma_px);
    return {normal(random_), normal(random_)};
  }
  Eigen::Vector2d left(const Eigen::Vector3d& p_mm, double sigma_px) {
    return project(truth_.left, p_mm) + noise(sigma_px);
  }
  Eigen::Vector2d right(const Eigen::Vector3d& p_mm, double sigma_px) {
    return project(truth_.right, truth_.right_T_left.isometry() * p_mm) + noise(sigma_px);
  }
  Eigen::Vector3d middle(double depth_mm) const {
    return 0.5 * truth_.right_T_left.inverse().translation_mm() + Eigen::Vector3d(0, 0, depth_mm);
  }
  StereoRig truth_;
  std::mt19937 random_;
};

RigEstimate judge(const StereoRig& calibrated, const StereoRig& truth, bool has_face, bool has_marker,
                  unsigned seed = 1, double size_mm = 60.0) {
  RigMonitor monitor(calibrated);
  Scene scene(truth, seed);
  for (int frame = 0; frame < 20; ++frame) {
    if (has_face) monitor.add(scene.face(6));
    if (has_marker) monitor.add(scene.marker(size_mm, 480 + 10 * frame));
  }
  return monitor.estimate();
}

TEST(RigMonitor, SaysNothingBeforeItHasSeenSomething) {
  const RigMonitor monitor(facenav::testing::convergingRig());
  EXPECT_EQ(monitor.estimate().state, RigState::unclear);
  EXPECT_EQ(monitor.estimate().verdict().words(), "");
}

TEST(RigMonitor, IsSilentOnRigsThatAreAsWellCalibratedAsRealOnes) {
  const auto rig = facenav::testing::convergingRig();
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  for (unsigned seed = 1; seed <= 40; ++seed) {
    const Eigen::Vector3d turn_deg(0.008 * normal(random), 0.004 * normal(random), 0.015 * normal(random));
    const auto verdict = judge(rig, moved(rig, turn_deg, {0, 0, 0}), true, seed % 2 == 0, seed);
    EXPECT_EQ(verdict.state, RigState::holds) << verdict.statistic << " seed " << seed;
  }
}

/// Random rigs as clinics build them: f 600-1000 px, baseline 60-200 mm, converging.
StereoRig someRig(std::mt19937& random) {
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  StereoRig rig = facenav::testing::convergingRig();
  const double f = uniform(600, 1000), baseline_mm = uniform(60, 200);
  for (CameraModel* camera : {&rig.left, &rig.right}) camera->k(0, 0) = f, camera->k(1, 1) = f;
  Eigen::Isometry3d pose = rig.right_T_left.isometry();
  pose.linear() = expRotation({0, uniform(0.5, 1.0) * std::atan2(baseline_mm, 620), uniform(-0.02, 0.02)});
  pose.translation() = pose.translation().normalized() * baseline_mm;
  rig.right_T_left = RigidTransform<RightCamera, Camera>::fromIsometry(pose);
  return rig;
}

RigEstimate judgeFace(const StereoRig& calibrated, const StereoRig& truth, unsigned seed) {
  RigMonitor monitor(calibrated);
  monitor.add(Scene(truth, seed).faceWithWrongMatches(150));
  return monitor.estimate();
}

TEST(RigMonitor, WrongMatchesAreNoMovedCamera) {
  std::mt19937 random(11);
  int moved_rigs = 0;
  for (unsigned seed = 1; seed <= 60; ++seed) {
    const StereoRig rig = someRig(random);
    moved_rigs += judgeFace(rig, rig, seed).hasMoved();
  }
  EXPECT_EQ(moved_rigs, 0) << "of 60 rigs that stand as calibrated";
}

TEST(RigMonitor, SeesCamerasThatMovedDespiteWrongMatches) {
  std::mt19937 random(12);
  std::uniform_real_distribution<double> angle_deg(0.1, 0.6);
  std::normal_distribution<double> normal;
  int seen = 0;
  for (unsigned seed = 1; seed <= 60; ++seed) {
    const StereoRig rig = someRig(random);
    // Pitch and roll; only squares show yaw.
    const Eigen::Vector3d axis = Eigen::Vector3d(normal(random), 0, normal(random)).normalized();
    seen += judgeFace(rig, moved(rig, angle_deg(random) * axis, {0, 0, 0}), seed).hasMoved();
  }
  // 0.1 degrees of roll with a short lens have less effect on a face than a calibration's error.
  EXPECT_GE(seen, 55) << "of 60";
  RecordProperty("seen_of_60", seen);
}

TEST(RigMonitor, SaysHowFarPointsAreOffAsFarAsTheImagesTell) {
  const auto rig = facenav::testing::convergingRig();
  const auto rolled = moved(rig, {0, 0, 0.3}, {0, 0, 0});
  RigMonitor monitor(rig);
  Scene scene(rolled, 7);
  const auto points = scene.face(600);
  monitor.add(points);
  const auto verdict = monitor.estimate();
  ASSERT_TRUE(verdict.hasMoved());
  EXPECT_NEAR(verdict.turn_rad.z() / kRadPerDeg, 0.3, 0.06);
  double squares = 0;
  for (const auto& p : points)
    squares += (triangulate(rig, p.left_px, p.right_px).mm - triangulate(rolled, p.left_px, p.right_px).mm)
                   .squaredNorm();
  const double truth_mm = std::sqrt(squares / double(points.size()));
  EXPECT_NEAR(verdict.displaced_mm, truth_mm,
              0.5 * truth_mm);  // yaw, which nothing determines, is not guessed
}

/// Compressed skin scatters far more than a match's own error says. That alone is no moved camera.
TEST(RigMonitor, MatchesThatScatterAreNoMovedCamera) {
  const auto rig = facenav::testing::convergingRig();
  RigMonitor monitor(rig);
  auto points = Scene(rig, 4).face(150);
  std::mt19937 random(5);
  std::normal_distribution<double> rows_px(0, 0.6);
  for (auto& point : points) point.right_px.y() += rows_px(random);
  monitor.add(points);
  EXPECT_FALSE(monitor.estimate().hasMoved());
}

TEST(RigMonitor, SeesPitchAndRollInTheFaceAlone) {
  const auto rig = facenav::testing::convergingRig();
  for (const Eigen::Vector3d& turn_deg :
       {Eigen::Vector3d(0.08, 0, 0), Eigen::Vector3d(-0.3, 0.2, 0.1), Eigen::Vector3d(0, 0, 0.6)}) {
    const auto verdict = judge(rig, moved(rig, turn_deg, {0, 0, 0}), true, false);
    EXPECT_TRUE(verdict.hasMoved()) << turn_deg.transpose() << ": " << verdict.statistic;
    EXPECT_NE(verdict.verdict().words().find("calibrate again"), std::string::npos);
  }
}

TEST(RigMonitor, SeesYawAndAnotherBaselineOnlyInAMarkersSize) {
  const auto rig = facenav::testing::convergingRig();
  for (const auto& truth : {moved(rig, {0, 0.25, 0}, {0, 0, 0}), moved(rig, {0, 0, 0}, {-2.5, 0, 0})}) {
    EXPECT_TRUE(judge(rig, truth, true, true).hasMoved());
    EXPECT_FALSE(judge(rig, truth, true, false).hasMoved()) << "invisible without a square of known size";
  }
}

TEST(RigMonitor, APrintALittleOffIsNoMovedCamera) {
  const auto rig = facenav::testing::convergingRig();
  EXPECT_FALSE(judge(rig, rig, true, true, 3, 60.15).hasMoved());
}

TEST(RigMonitor, ForgetsSoThatAKnockDuringTheSessionIsSeen) {
  const auto rig = facenav::testing::convergingRig();
  RigMonitor monitor(rig);
  Scene before(rig, 1), after(moved(rig, {0.15, 0, 0}, {0, 0, 0}), 2);
  for (int frame = 0; frame < 300; ++frame) monitor.add(before.face(6));
  ASSERT_EQ(monitor.estimate().state, RigState::holds);
  int frames = 0;
  for (; frames < 200 && !monitor.estimate().hasMoved(); ++frames) monitor.add(after.face(6));
  EXPECT_LT(frames, 120);
}

/// State that RigHealth names after some frames of a pair whose right camera turned.
RigState named(int frames, bool has_square) {
  const auto rig = facenav::testing::convergingRig();
  Scene scene(moved(rig, {0.3, 0, 0}, {0, 0, 0}), 3);
  RigHealth health(rig);
  for (int i = 0; i < frames; ++i) {
    RigObservation seen;
    seen.captured.s = i / 30.0;
    seen.matches = scene.face(30);
    if (has_square) seen.square = scene.marker(60, 600);
    health.add(seen);
  }
  const auto fault = health.fault();
  return fault ? fault->state : RigState::unclear;
}

TEST(RigHealth, NamesAMovedCameraFromSkinOnlyAfterManyFrames) {
  EXPECT_EQ(named(2, false), RigState::disagree) << "the head may have moved between the exposures";
  EXPECT_EQ(named(2, true), RigState::moved) << "a square at rest tells";
  EXPECT_EQ(named(int(kFirstFrames) + 2, false), RigState::moved);
}

TEST(PatchMatch, FindsATexturedPatchThatMovedInBothDirections) {
  cv::Mat_<float> texture(120, 160);
  cv::RNG random(3);
  const double fx = 0.31, fy = 0.23, dx = 2.3, dy = -1.6;
  const auto grey = [&](double x, double y) {
    return 120 + 40 * std::sin(fx * x + 0.1 * y) * std::cos(fy * y) + 20 * std::sin(0.7 * x - 0.45 * y);
  };
  cv::Mat_<std::uint8_t> left(120, 160), right(120, 160);
  for (int y = 0; y < 120; ++y)
    for (int x = 0; x < 160; ++x) {
      left(y, x) = cv::saturate_cast<std::uint8_t>(grey(x, y) + random.gaussian(1.5));
      right(y, x) = cv::saturate_cast<std::uint8_t>(0.8 * grey(x - dx, y - dy) + 15 + random.gaussian(1.5));
    }
  const auto match = matchPatch(left, right, {70.4, 60.7}, {70.4, 60.7});
  ASSERT_TRUE(match);
  EXPECT_NEAR(match->right_px.x(), 70.4 + dx, 0.1);
  EXPECT_NEAR(match->right_px.y(), 60.7 + dy, 0.1);
  EXPECT_FALSE(matchPatch(left, cv::Mat(120, 160, CV_8U, cv::Scalar(90)), {70, 60}, {70, 60}));
  EXPECT_FALSE(matchPatch(left, right, {4, 60}, {6, 58})) << "leaves the image";
}

}  // namespace
}  // namespace facenav::health
