// Properties of all scripts of the room: smooth starts, limits of size and speed, blinks, the same for a
// seed.

#include <gtest/gtest.h>

#include <cmath>

#include "egg_patient.h"
#include "facenav/core/error.h"
#include "facenav/geometry/rotation.h"
#include "patient/thin_plate.h"
#include "props/coil_mount.h"
#include "script/dice.h"
#include "script/habits.h"
#include "script/script_setting.h"
#include "support/matchers.h"

namespace facenav::room {
namespace {

using testing::EigenNear;

TEST(Ease, GoesFromZeroToOneWithoutAJerk) {
  EXPECT_EQ(ease(-3), 0);
  EXPECT_EQ(ease(0), 0);
  EXPECT_EQ(ease(1), 1);
  EXPECT_EQ(ease(7), 1);
  for (double x = 0; x < 1; x += 0.05) {
    EXPECT_LT(ease(x), ease(x + 0.05)) << x;
    EXPECT_NEAR(ease(x) + ease(1 - x), 1, 1e-12) << "symmetric";
  }
  for (const double end : {0.0, 1.0}) {
    const double h = 1e-3;
    EXPECT_NEAR((ease(end + h) - ease(end - h)) / (2 * h), 0, 1e-4) << "no speed at the ends";
    EXPECT_NEAR((ease(end + h) - 2 * ease(end) + ease(end - h)) / (h * h), 0, 0.05) << "no acceleration";
  }
}

TEST(Hill, RisesToOneInTheMiddle) {
  EXPECT_EQ(hill(0), 0);
  EXPECT_EQ(hill(0.5), 1);
  EXPECT_EQ(hill(1), 0);
  EXPECT_NEAR(hill(0.3), hill(0.7), 1e-12);
}

TEST(Parts, GiveTheLabelAndTheShareInside) {
  const Parts parts({{0.25, "one"}, {0.75, "two"}, {1.1, "three"}});
  EXPECT_STREQ(parts.at(0).label, "one");
  EXPECT_STREQ(parts.at(0.25).label, "two");
  EXPECT_NEAR(parts.at(0.25).inside, 0, 1e-12);
  EXPECT_NEAR(parts.at(0.5).inside, 0.5, 1e-12);
  EXPECT_STREQ(parts.at(1.0).label, "three");
}

TEST(HeadMotion, StartsAtRestAndStaysWithinItsSize) {
  const MotionSize size;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const HeadMotion motion(size, seed);
    EXPECT_EQ(motion.at(0).norm(), 0.0);
    EXPECT_LT(motion.at(0.004).norm(), 0.02) << "no jump at the start";
    Eigen::Matrix<double, 6, 1> peak;
    peak << size.rotation_deg, size.shift_mm;
    for (double t = 0; t < 20; t += 0.05)
      EXPECT_TRUE((motion.at(t).cwiseAbs().array() <= 2 * peak.array()).all()) << seed << ", " << t;
  }
}

TEST(HeadMotion, IsTheSameForASeedAndScalesWithItsSize) {
  MotionSize twice;
  twice.rotation_deg *= 2, twice.shift_mm *= 2;
  const HeadMotion a({}, 5), b({}, 5), other({}, 6), larger(twice, 5);
  EXPECT_EQ(a.at(1.7), b.at(1.7));
  EXPECT_GT((a.at(1.7) - other.at(1.7)).norm(), 0.1);
  EXPECT_LT((larger.at(1.7) - 2 * a.at(1.7)).norm(), 1e-9);
}

TEST(Blinks, LastATenthToThreeTenthsOfASecondEveryTwoToSixSeconds) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const double step_s = 0.002;
    std::vector<std::pair<double, double>> blinks;  // start, end
    bool is_down = false;
    for (double t = 0; t < 60; t += step_s) {
      const double lids = lidsDown(seed, t);
      ASSERT_GE(lids, 0.0);
      ASSERT_LE(lids, 1.0);
      if (lids > 0 && !is_down) blinks.emplace_back(t, t);
      if (lids > 0) blinks.back().second = t;
      is_down = lids > 0;
    }
    ASSERT_GE(blinks.size(), 9u) << seed;
    ASSERT_LE(blinks.size(), 30u) << seed;
    for (std::size_t i = 0; i < blinks.size(); ++i) {
      if (blinks[i].second < 59.5) {
        EXPECT_GT(blinks[i].second - blinks[i].first, 0.08) << seed;
      }
      EXPECT_LT(blinks[i].second - blinks[i].first, 0.31) << seed;
      if (i > 0) {
        EXPECT_GT(blinks[i].first - blinks[i - 1].first, 2.0 - 0.01) << seed;
        EXPECT_LT(blinks[i].first - blinks[i - 1].first, 6.0 + 0.02) << seed;
      }
    }
  }
}

TEST(Blinks, CloseTheEyesFully) {
  double most = 0;
  for (double t = 0; t < 20; t += 0.001) most = std::max(most, lidsDown(2, t));
  EXPECT_GT(most, 0.999);
}

TEST(Dice, AreUniformAndTheSameForASeed) {
  Dice a(9), b(9), c(10);
  double sum = 0, squares = 0;
  bool differs = false;
  for (int i = 0; i < 20000; ++i) {
    const double value = a.between(-2, 4);
    ASSERT_EQ(value, b.between(-2, 4));
    differs |= value != c.between(-2, 4);
    ASSERT_GE(value, -2);
    ASSERT_LT(value, 4);
    sum += value, squares += value * value;
  }
  EXPECT_TRUE(differs);
  EXPECT_NEAR(sum / 20000, 1.0, 0.05);
  EXPECT_NEAR(squares / 20000 - 1, 36.0 / 12, 0.1);
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (int i = 0; i < 20000; ++i) {
    const Eigen::Vector3d d = a.direction();
    ASSERT_NEAR(d.norm(), 1, 1e-9);
    mean += d / 20000;
  }
  EXPECT_LT(mean.norm(), 0.03);
}

struct Played {
  std::shared_ptr<const VirtualPatient> patient = testing::eggPatient();
  std::unique_ptr<Script> operator()(const ScenarioOptions& options) const {
    return makeScript(options, *patient, leftHandArea(*patient), {});
  }
};

ScenarioOptions named(const char* name, std::uint64_t seed = 1) {
  ScenarioOptions options;
  options.name = name;
  options.seed = seed;
  return options;
}

TEST(Scripts, AreTheSameForTheSameSeed) {
  const Played played;
  for (const auto& kind : scenarios()) {
    const auto a = played(named(kind.name.c_str(), 4)), b = played(named(kind.name.c_str(), 4));
    for (const double frame : {0.0, 7.0, 20.5, double(kind.frames - 1)}) {
      const auto x = a->at(frame), y = b->at(frame);
      EXPECT_EQ(x.cast.room_T_mri.matrix(), y.cast.room_T_mri.matrix()) << kind.name;
      EXPECT_EQ(x.label, y.label) << kind.name;
      EXPECT_EQ(x.cast.jaw_mm, y.cast.jaw_mm) << kind.name;
      EXPECT_EQ(x.cast.lamp_scale, y.cast.lamp_scale) << kind.name;
    }
  }
}

TEST(Scripts, AskedTwiceOrOutOfOrderGiveTheSameMoment) {
  const auto script = Played()(named("treatment"));
  const auto late = script->at(100).cast.room_T_mri.matrix();
  script->at(3);
  EXPECT_EQ(script->at(100).cast.room_T_mri.matrix(), late);
}

TEST(Scripts, OfOneSittingMoveTheHeadLessThanTheFastestScenario) {
  const Played played;
  for (const char* name : {"treatment", "occlusion", "talking", "lighting", "glint", "mask"}) {
    const auto options = named(name);
    const auto script = played(options);
    const auto face = [&](int frame) {
      return (script->at(frame).cast.room_T_mri * played.patient->face_middle).mm;
    };
    for (int frame = 1; frame < script->frameCount(); ++frame)
      ASSERT_LT((face(frame) - face(frame - 1)).norm() * options.frames_per_s, 100.0)
          << name << ", " << frame;
  }
}

TEST(Scripts, TheMotionOptionScalesTheMotion) {
  const Played played;
  auto none = named("free_motion");
  none.motion = 0;
  const auto still = played(none);
  const auto seat = still->capture().room_T_mri;
  EXPECT_LT((still->at(120).cast.room_T_mri.matrix() - seat.matrix()).norm(), 1e-9);
  auto half = named("free_motion");
  half.motion = 0.5;
  const auto turn = [&](const ScenarioOptions& options) {
    const auto script = played(options);
    return logRotation(script->at(60).cast.room_T_mri.rotation() * seat.rotation().transpose());
  };
  EXPECT_THAT(turn(half), EigenNear(Eigen::Vector3d(0.5 * turn(named("free_motion"))), 1e-9));
}

TEST(Scripts, TheFrameRateChangesTheTimesAndNotThePath) {
  const Played played;
  auto slow = named("free_motion"), fast = named("free_motion");
  slow.frames_per_s = 30, fast.frames_per_s = 120;
  EXPECT_LT(
      (played(slow)->at(30).cast.room_T_mri.matrix() - played(fast)->at(120).cast.room_T_mri.matrix()).norm(),
      1e-9);
}

TEST(Hair, StandsStillWithoutSwayAndNeverLeansFarther) {
  const RigidTransform<Room, Mri> seat(Eigen::Quaterniond::Identity(), {0, 0, 600});
  const RigidTransform<Room, Mri> turned(Eigen::Quaterniond(expRotation({0.5, 0.6, -0.3})), {0, 0, 600});
  EXPECT_EQ(looseHair(0, seat, turned, 1, 2).lean_mm.norm(), 0.0);
  for (const double sway_mm : {1.0, 4.0}) {
    EXPECT_LE(looseHair(sway_mm, seat, turned, 1, 0).lean_mm.norm(), sway_mm + 1e-9);
    EXPECT_EQ(looseHair(sway_mm, seat, seat, 1, 0).lean_mm.norm(), 0.0);
  }
  EXPECT_EQ(looseHair(4, seat, seat, 1, 0).pattern, 0u);
  EXPECT_NE(looseHair(4, seat, seat, 1, 1).pattern, looseHair(4, seat, seat, 1, 2).pattern);
}

TEST(ThinPlate, WithoutStiffnessPassesThroughItsKnots) {
  std::vector<Eigen::Vector2d> from, to;
  for (int i = 0; i < 9; ++i) {
    from.emplace_back(20 * (i % 3), 25 * (i / 3));
    to.push_back(from.back() + Eigen::Vector2d(3 * std::sin(i), 2 * std::cos(2 * i)));
  }
  const ThinPlate plate(from, to, 0);
  for (int i = 0; i < 9; ++i) EXPECT_THAT(plate.at(from[i]), EigenNear(to[i], 1e-6));
}

TEST(ThinPlate, KeepsAnAffineMapWhateverItsStiffness) {
  Eigen::Matrix2d map;
  map << 1.2, 0.1, -0.2, 0.9;
  std::vector<Eigen::Vector2d> from, to;
  for (int i = 0; i < 12; ++i) {
    from.emplace_back(10 * (i % 4) + i, 15 * (i / 4));
    to.push_back(map * from.back() + Eigen::Vector2d(5, -3));
  }
  for (const double stiffness : {0.0, 1.0, 100.0}) {
    const ThinPlate plate(from, to, stiffness);
    for (const Eigen::Vector2d& p : {Eigen::Vector2d(7, 7), {-30, 80}})
      EXPECT_THAT(plate.at(p), EigenNear(Eigen::Vector2d(map * p + Eigen::Vector2d(5, -3)), 1e-5));
  }
}

TEST(RandomRig, KeepsItsStatedLimitsAndItsSeedDecides) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const auto options = randomRig(seed);
    EXPECT_GE(options.focal_px, 600);
    EXPECT_LE(options.focal_px, 1000);
    EXPECT_GE(options.baseline_mm, 60);
    EXPECT_LE(options.baseline_mm, 200);
    EXPECT_LE(std::abs(options.roll_deg), 20);
    const double full_deg = 2 * std::atan(options.baseline_mm / 2 / 600) * 180 / M_PI;
    EXPECT_GE(options.convergence_deg, 0.5 * full_deg - 0.5) << seed;
    EXPECT_LE(options.convergence_deg, full_deg + 0.5) << seed;
    EXPECT_NEAR(makeRig(options).baseline_mm(), options.baseline_mm, 1e-9);
  }
  EXPECT_EQ(randomRig(3).focal_px, randomRig(3).focal_px);
  EXPECT_NE(randomRig(3).focal_px, randomRig(4).focal_px);
}

TEST(RoomFrame, LiesMidwayBetweenTheCamerasWithGravityDown) {
  for (const double roll_deg : {0.0, 30.0, 90.0}) {
    RigOptions options;
    options.roll_deg = roll_deg;
    const auto rig = makeRig(options);
    const auto camera_T_room = cameraFromRoom(rig, roll_deg);
    const Eigen::Vector3d right_centre = rig.right_T_left.inverse().translation_mm();
    EXPECT_THAT(camera_T_room.translation_mm(), EigenNear(Eigen::Vector3d(0.5 * right_centre), 1e-9));
    const Eigen::Vector3d across = camera_T_room.inverse().rotation() * right_centre.normalized();
    EXPECT_NEAR(std::abs(std::atan2(across.y(), across.x())) * 180 / M_PI, roll_deg, 2.0)
        << "the rig is rolled, the room is not";
  }
}

}  // namespace
}  // namespace facenav::room
