// A living head besides its pose: blinks and moving hair.
#include <gtest/gtest.h>

#include "egg_patient.h"
#include "facenav/room/synthetic_source.h"
#include "patient/eyelid.h"
#include "patient/face_shape.h"
#include "patient/loose_hair.h"
#include "script/habits.h"

namespace facenav::room {
namespace {

/// The egg's surface in front of a point of its middle plane.
Eigen::Vector3d onEgg(double x, double z) {
  const double dx = (x - 2.0) / 75.0, dz = (z + 10.0) / 110.0;
  return {x, 5.0 + 95.0 * std::sqrt(1.0 - dx * dx - dz * dz), z};
}

/// The egg with eyes; the rest of its 68 points are inside it.
std::shared_ptr<const VirtualPatient> eggWithEyes() {
  auto patient = std::make_shared<VirtualPatient>(*testing::eggPatient());
  patient->landmarks68_mm.assign(68, Eigen::Vector3d(0.0, 40.0, -60.0));
  for (const auto& [first, side] : {std::pair{36, 1.0}, {42, -1.0}}) {
    const double outer = first == 36 ? 46.0 : 18.0, inner = first == 36 ? 18.0 : 46.0;
    const double along[6] = {0.0, 1.0 / 3, 2.0 / 3, 1.0, 2.0 / 3, 1.0 / 3}, up[6] = {0, 5, 5, 0, -4, -4};
    for (int i = 0; i < 6; ++i)
      patient->landmarks68_mm[std::size_t(first + i)] =
          onEgg(side * (outer + along[i] * (inner - outer)), 8.0 + up[i]);
  }
  return patient;
}

ScenarioOptions still(int frames) {
  ScenarioOptions options;
  options.name = "still";
  options.frames = frames;
  options.noise_grey = 0.0;
  options.rig = testing::smallRig();
  options.rig.width_px = 320, options.rig.height_px = 240, options.rig.focal_px = 400.0;
  return options;
}

std::vector<cameras::StereoFrame> filmed(const ScenarioOptions& options,
                                         std::shared_ptr<const VirtualPatient> patient,
                                         std::vector<GroundTruth>* truths = nullptr) {
  SyntheticSource source(options, std::move(patient));
  std::vector<cameras::StereoFrame> frames;
  while (const auto frame = source.next()) {
    frames.push_back(*frame);
    if (truths) truths->push_back(source.truth());
  }
  return frames;
}

TEST(Blink, LastsATenthToThreeTenthsOfASecondEveryTwoToSixSeconds) {
  constexpr double kStep_s = 0.001;
  for (const std::uint64_t seed : {1u, 2u, 3u, 40u}) {
    double began_s = -1.0, last_began_s = -1.0, deepest = 0.0;
    int blinks = 0;
    for (int i = 0; i < 60000; ++i) {
      const double t = i * kStep_s, down = lidsDown(seed, t);
      deepest = std::max(deepest, down);
      if (down > 0.0 && began_s < 0.0) {
        if (last_began_s >= 0.0) {
          EXPECT_GE(t - last_began_s, 2.0 - 2 * kStep_s);
          EXPECT_LE(t - last_began_s, 6.0 + 2 * kStep_s);
        }
        began_s = last_began_s = t;
        ++blinks;
      } else if (down == 0.0 && began_s >= 0.0) {
        EXPECT_GE(t - began_s, 0.1 - 3 * kStep_s);
        EXPECT_LE(t - began_s, 0.3 + 3 * kStep_s);
        began_s = -1.0;
      }
    }
    EXPECT_GE(blinks, 9) << seed;
    EXPECT_LE(deepest, 1.0);
    EXPECT_GT(deepest, 0.99);
  }
}

TEST(Blink, MovesTheLidsByMillimetresAndNothingBeyondTheEyes) {
  const auto patient = eggWithEyes();
  const auto& l = patient->landmarks68_mm;
  double lid_mm = 0.0;
  for (std::size_t i = 0; i < patient->skin.vertices_mm.size(); ++i) {
    const Eigen::Vector3d& p = patient->skin.vertices_mm[i];
    const double moved_mm = lidShift_mm(1.0, p, patient->skin.normals[i], l).norm();
    const double away_mm = std::min((p - onEgg(32, 8)).norm(), (p - onEgg(-32, 8)).norm());
    if (away_mm > 26.0) {
      EXPECT_EQ(moved_mm, 0.0);
    }
    lid_mm = std::max(lid_mm, moved_mm);
  }
  EXPECT_GT(lid_mm, 1.0);
  EXPECT_LT(lid_mm, 4.0);
  EXPECT_EQ(lidPaint(0.0, onEgg(32, 8), l).share, 0.f) << "open";
  EXPECT_GT(lidPaint(1.0, onEgg(32, 8), l).share, 0.9f) << "closed";
  EXPECT_GT(lidPaint(0.5, onEgg(32, 12), l).share, 0.9f) << "half closed, above the rim";
  EXPECT_EQ(lidPaint(0.5, onEgg(32, 5), l).share, 0.f) << "half closed, below the rim";
}

TEST(Blink, ChangesTheImageAtTheEyesAndNowhereElse) {
  const auto patient = eggWithEyes();
  auto options = still(400);
  options.frames_per_s = 60.0;
  double at_s = 0.0;
  while (lidsDown(options.seed, at_s) < 1.0) at_s += 1.0 / options.frames_per_s;
  options.frames = 1;
  options.frames_per_s = 60.0;
  const auto open = filmed(options, patient);
  // One frame later, the time is at the middle of a blink: the second frame has the lids down.
  options.frames = 2;
  options.frames_per_s = 1.0 / at_s;
  options.blinks = 1;
  std::vector<GroundTruth> truths;
  const auto blinking = filmed(options, patient, &truths);
  EXPECT_EQ(cv::norm(blinking[0].left, open[0].left, cv::NORM_INF), 0.0) << "not yet";
  const auto rig = makeRig(options.rig);
  const Eigen::Isometry3d camera_T_mri = truths[1].camera_T_mri.isometry();
  cv::Mat changed;
  cv::absdiff(blinking[1].left, open[0].left, changed);
  double inside = 0.0, outside = 0.0;
  for (int y = 0; y < changed.rows; ++y)
    for (int x = 0; x < changed.cols; ++x) {
      double away_px = 1e9;
      for (const double side : {1.0, -1.0})
        away_px = std::min(away_px, (cameras::project(rig.left, camera_T_mri * onEgg(32.0 * side, 8.0)) -
                                     Eigen::Vector2d(x, y))
                                        .norm());
      double& worst = away_px < 26.0 * options.rig.focal_px / 500.0 ? inside : outside;
      worst = std::max(worst, double(changed.at<std::uint8_t>(y, x)));
    }
  EXPECT_GT(inside, 20.0);
  EXPECT_LE(outside, 1.0);
}

HairPose swaying(std::uint64_t pattern) {
  HairPose hair;
  hair.sway_mm = 4.0;
  hair.pattern = pattern;
  return hair;
}

TEST(Hair, MovesAgainstTheSkullByAFewMillimetresAndSkinStays) {
  const auto patient = testing::eggPatient();
  FaceShape face(*patient);
  ASSERT_TRUE(face.set(0.0, 0.0, {}, swaying(3)));
  double largest_mm = 0.0;
  for (std::size_t i = 0; i < patient->hair.size(); ++i) {
    const double moved_mm = (face.vertices_mm()[i] - patient->visible.vertices_mm[i]).norm();
    if (patient->hair[i] == 0.f) {
      EXPECT_EQ(moved_mm, 0.0);
    }
    largest_mm = std::max(largest_mm, moved_mm);
  }
  EXPECT_GT(largest_mm, 2.0);
  EXPECT_LE(largest_mm, 4.0 + 1e-9);
  ASSERT_TRUE(face.set(0.0, 0.0, {}, swaying(0)));
  EXPECT_TRUE(face.isAtRest());
  for (std::size_t i = 0; i < patient->hair.size(); ++i)
    EXPECT_EQ(face.vertices_mm()[i], patient->visible.vertices_mm[i]);
}

TEST(Hair, LocksKeepTheirRootsAndMoveTheirTips) {
  const LooseHair hair(*testing::eggPatient(), 1), again(*testing::eggPatient(), 1);
  ASSERT_GT(hair.mesh().triangles.size(), 1000u);
  EXPECT_EQ(hair.mesh().vertices_mm, again.mesh().vertices_mm);
  const auto moved = hair.vertices_mm(swaying(2));
  double least_mm = 1e9, most_mm = 0.0;
  for (std::size_t i = 0; i < moved.size(); ++i) {
    const double by_mm = (moved[i] - hair.mesh().vertices_mm[i]).norm();
    least_mm = std::min(least_mm, by_mm), most_mm = std::max(most_mm, by_mm);
  }
  EXPECT_EQ(least_mm, 0.0);
  EXPECT_GT(most_mm, 2.0);
  EXPECT_LE(most_mm, 6.0 + 1e-9);
  VirtualPatient bald = *testing::eggPatient();
  bald.hair.assign(bald.hair.size(), 0.f);
  EXPECT_TRUE(LooseHair(bald, 1).mesh().triangles.empty());
}

TEST(Hair, LiesOtherwiseAfterEachVisitAndLagsBehindATurn) {
  const auto seat = seatedHead({}, *testing::eggPatient());
  EXPECT_TRUE(looseHair(4.0, seat, seat, 1, 0).isAtRest());
  EXPECT_TRUE(looseHair(0.0, seat, seat, 1, 2).isAtRest());
  EXPECT_NE(looseHair(4.0, seat, seat, 1, 1).pattern, looseHair(4.0, seat, seat, 1, 2).pattern);
  // Turned towards Mri's +x about the vertical axis: the front moves to -x, the hair lags to +x.
  const double angle = 0.1;
  Eigen::Isometry3d turn = Eigen::Isometry3d::Identity();
  turn.linear() = Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  const auto now = RigidTransform<Room, Mri>::fromIsometry(seat.isometry() * turn);
  EXPECT_NEAR(looseHair(4.0, seat, now, 1, 0).lean_mm.x(), 2.0, 0.01);
  EXPECT_NEAR(looseHair(4.0, seat, now, 1, 0).lean_mm.tail<2>().norm(), 0.0, 1e-9);
}

TEST(Hair, LooseHairChangesThePictureAndNotTheTruth) {
  auto options = still(2);
  options.name = "free_motion";
  std::vector<GroundTruth> fixed_truth, loose_truth;
  const auto fixed = filmed(options, testing::eggPatient(), &fixed_truth);
  options.hair_sway_mm = 4.0;
  const auto loose = filmed(options, testing::eggPatient(), &loose_truth);
  EXPECT_GT(cv::norm(fixed[1].left, loose[1].left, cv::NORM_INF), 10.0);
  for (int i : {0, 1})
    EXPECT_EQ(fixed_truth[std::size_t(i)].camera_T_mri.matrix(),
              loose_truth[std::size_t(i)].camera_T_mri.matrix());
}

}  // namespace
}  // namespace facenav::room
