#include "script/script.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "egg_patient.h"
#include "facenav/core/error.h"
#include "facenav/geometry/rotation.h"
#include "props/coil_mount.h"
#include "support/matchers.h"

namespace facenav::room {
namespace {

ScenarioOptions named(const char* name, int frames = 0) {
  ScenarioOptions options;
  options.name = name;
  options.frames = frames;
  return options;
}

struct Played {
  std::shared_ptr<const VirtualPatient> patient = testing::eggPatient();
  RigidTransform<Mri, frames::Target> target = leftHandArea(*patient);
  cameras::StereoRig rig = makeRig({});
  RigidTransform<Marker, Coil> marker_T_coil =
      mountedCoil(target, *patient, {rig, cameraFromRoom(rig), seatedHead({}, *patient)}).marker_T_coil;
  std::unique_ptr<Script> operator()(const ScenarioOptions& options) const {
    return makeScript(options, *patient, target, marker_T_coil);
  }
};

TEST(Scenario, EachOfTheTableCanBePlayedToItsEnd) {
  const Played played;
  for (const auto& kind : scenarios()) {
    const auto script = played(named(kind.name.c_str()));
    EXPECT_EQ(script->frameCount(), kind.frames);
    for (int frame = 0; frame < kind.frames; ++frame)
      EXPECT_FALSE(script->at(frame).label.empty()) << kind.name;
  }
}

TEST(Scenario, DriftMovesTheRightCameraSlowlyInTheAxisAskedFor) {
  const Played played;
  const char* const about[] = {"yaw", "pitch", "roll", "shift"};
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {  // in turn, if no axis is given
    auto options = named("drift", 31);
    options.seed = seed;
    const auto script = played(options);
    EXPECT_TRUE(script->capture().right_moved.matrix().isIdentity());
    EXPECT_TRUE(script->at(0).cast.right_moved.matrix().isIdentity());
    const Eigen::Isometry3d last = script->at(30).cast.right_moved, middle = script->at(15).cast.right_moved;
    const Eigen::Vector3d turn_deg = kDegPerRad * logRotation(last.linear());
    const bool is_shift = std::string(about[seed - 1]) == "shift";
    EXPECT_NEAR(turn_deg.norm(), is_shift ? 0.0 : 0.3, 1e-9);
    EXPECT_NEAR(last.translation().norm(), is_shift ? 1.0 : 0.0, 1e-9);
    EXPECT_NEAR(rotationAngle(middle.linear()), 0.5 * rotationAngle(last.linear()), 1e-9);
    options.seed = 9, options.drift_about = about[seed - 1];
    const auto asked = played(options)->at(30).cast.right_moved;
    EXPECT_NEAR(logRotation(asked.linear()).normalized().cwiseAbs().maxCoeff(), is_shift ? 0.0 : 1.0, 1e-9);
    if (!is_shift) {
      EXPECT_EQ((kDegPerRad * logRotation(asked.linear())).cwiseAbs().maxCoeff() > 0.29,
                turn_deg.cwiseAbs().maxCoeff() > 0.29);
    }
    EXPECT_TRUE(script->at(15).cast.room_T_coil.has_value());
  }
  EXPECT_FALSE(played(named("drift_face", 31))->at(15).cast.room_T_coil.has_value());
  auto wrong = named("drift");
  wrong.drift_about = "sideways";
  EXPECT_THROW(played(wrong), Error);
}

TEST(Scenario, WebcamsHaveTheirOwnShutterAndClocksUnlessOptionsSayOtherwise) {
  EXPECT_EQ(resolved(named("treatment")).rolling_ms, 0.0);
  EXPECT_EQ(resolved(named("webcam")).rolling_ms, 20.0);
  EXPECT_EQ(resolved(named("webcam")).right_late_ms, 0.0);
  EXPECT_EQ(resolved(named("unsynced")).right_late_ms, 9.0);
  EXPECT_GT(resolved(named("autoexposure")).exposure_step, 0.0);
  EXPECT_EQ(resolved(named("refocus")).refocus_px, 1.5);
  auto slow = named("webcam");
  slow.rolling_ms = 33.0, slow.rig_name = "1080p";
  EXPECT_EQ(resolved(slow).rolling_ms, 33.0);
  EXPECT_EQ(resolved(slow).rig.width_px, 1920);
  EXPECT_NEAR(resolved(slow).rig.focal_px, 0.83 * 1920, 1e-9);
}

TEST(Scenario, TheFastCoilIsFastAndTheGlassesAreNotWornAtFirst) {
  const Played played;
  const auto coil = played(named("fast_coil", 120));
  double most_mm_s = 0;
  for (int frame = 1; frame < 120; ++frame)
    most_mm_s = std::max(most_mm_s, 30.0 * (coil->at(frame).cast.room_T_coil->translation_mm() -
                                            coil->at(frame - 1).cast.room_T_coil->translation_mm())
                                               .norm());
  EXPECT_GT(most_mm_s, 200.0);
  EXPECT_LT(most_mm_s, 400.0);
  const auto glasses = played(named("glasses", 30));
  EXPECT_FALSE(glasses->capture().has_glasses);
  EXPECT_FALSE(glasses->at(0).cast.has_glasses);
  EXPECT_TRUE(glasses->at(29).cast.has_glasses);
}

TEST(Scenario, UnknownNameIsAnErrorThatListsTheOthers) {
  try {
    Played()(named("treatmnt"));
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("free_motion"), std::string::npos);
  }
}

TEST(PlainAlign, TurnsTheHeadSlowlyToBothSidesFromWhereTheCaptureSawIt) {
  const Played played;
  const auto options = named(kPlainAlign);
  const auto script = played(options);
  const auto start = script->capture().room_T_mri;
  const double frames_per_s = resolved(options).frames_per_s;
  EXPECT_NEAR(script->frameCount() / frames_per_s, 2.0, 0.1);
  double least_deg = 0, most_deg = 0, fastest_deg_s = 0;
  for (int frame = 0; frame < script->frameCount(); ++frame) {
    const auto turn =
        logRotation(script->at(frame).cast.room_T_mri.rotation() * start.rotation().transpose());
    const auto next =
        logRotation(script->at(frame + 1).cast.room_T_mri.rotation() * start.rotation().transpose());
    least_deg = std::min(least_deg, turn.y() * 180 / M_PI),
    most_deg = std::max(most_deg, turn.y() * 180 / M_PI);
    fastest_deg_s = std::max(fastest_deg_s, (next - turn).norm() * 180 / M_PI * frames_per_s);
    if (frame == 0) {
      EXPECT_LT(turn.norm(), 1e-9);
    }
  }
  EXPECT_LT(least_deg, -12);
  EXPECT_GT(most_deg, 12);
  EXPECT_LT(fastest_deg_s, 60) << "slowly";
}

TEST(Treatment, HoldsTheTargetForTheLastSecond) {
  const Played played;
  const auto options = named("treatment", 150);
  const auto script = played(options);
  for (int frame = 150 - int(options.frames_per_s) + 1; frame < 150; ++frame) {
    const auto cast = script->at(frame).cast;
    const auto mri_T_coil = cast.room_T_mri.inverse() * *cast.room_T_coil;
    EXPECT_LT((mri_T_coil.translation_mm() - played.target.translation_mm()).norm(), 1e-6) << frame;
    EXPECT_LT(rotationAngle(mri_T_coil.rotation().transpose() * played.target.rotation()), 1e-7) << frame;
  }
  const auto start = script->at(0).cast;
  const double away_mm =
      ((start.room_T_mri.inverse() * *start.room_T_coil).translation_mm() - played.target.translation_mm())
          .norm();
  EXPECT_NEAR(away_mm, 150.0, 5.0);
}

TEST(Protractor, TurnsBy25DegInElevenStepsAboutEachAxis) {
  const Played played;
  const auto script = played(named("protractor"));
  const auto seat = script->capture().room_T_mri;
  for (int frame = 0; frame < 33; ++frame) {
    const auto room_T_mri = script->at(frame).cast.room_T_mri;
    const Eigen::Vector3d turned_deg =
        logRotation(room_T_mri.rotation() * seat.rotation().transpose()) * 180.0 / M_PI;
    Eigen::Vector3d expected = Eigen::Vector3d::Zero();
    expected[frame / 11] = 2.5 * (frame % 11 - 5);
    EXPECT_THAT(turned_deg, testing::EigenNear(expected, 1e-9)) << frame;
    EXPECT_LT(
        ((room_T_mri * played.patient->head_centre).mm - (seat * played.patient->head_centre).mm).norm(),
        1e-9);
  }
}

TEST(FreeMotion, ReachesItsStatedSizeAndStaysBelowItsSpeed) {
  const Played played;
  for (const std::uint64_t seed : {1u, 2u, 3u, 4u, 5u}) {
    auto options = named("free_motion", 300);
    options.seed = seed;
    const auto script = played(options);
    const auto seat = script->capture().room_T_mri;
    double fastest_mm_s = 0.0, farthest_mm = 0.0;
    Eigen::Vector3d turned_deg = Eigen::Vector3d::Zero();
    for (int frame = 1; frame < 300; ++frame) {
      const auto before = script->at(frame - 1).cast.room_T_mri * played.patient->head_centre;
      const auto now = script->at(frame).cast.room_T_mri;
      const auto after = now * played.patient->head_centre;
      fastest_mm_s = std::max(fastest_mm_s, (after.mm - before.mm).norm() * options.frames_per_s);
      farthest_mm =
          std::max(farthest_mm, (after.mm - (seat * played.patient->head_centre).mm).cwiseAbs().maxCoeff());
      turned_deg = turned_deg.cwiseMax(
          (logRotation(now.rotation() * seat.rotation().transpose()) * 180.0 / M_PI).cwiseAbs());
    }
    EXPECT_GT(fastest_mm_s, 60.0) << seed;
    EXPECT_LT(fastest_mm_s, 110.0) << seed;
    EXPECT_NEAR(farthest_mm, 60.0, 3.0) << seed;
    EXPECT_NEAR(turned_deg.x(), 15.0, 1.0) << "pitch, seed " << seed;
    EXPECT_NEAR(turned_deg.y(), 30.0, 1.0) << "yaw, seed " << seed;
    EXPECT_NEAR(turned_deg.z(), 15.0, 1.0) << "roll, seed " << seed;
  }
}

TEST(SeatedHead, TheSeedSeatsThePatientAskewWithinItsLimits) {
  const auto patient = testing::eggPatient();
  ScenarioOptions straight, askew;
  askew.seat_turn_deg = 30.0;
  askew.seat_shift_mm = 60.0;
  const auto seat = seatedHead(straight, *patient);
  double largest_deg = 0.0;
  for (askew.seed = 1; askew.seed <= 30; ++askew.seed) {
    const auto other = seatedHead(askew, *patient);
    const double deg = rotationAngle(other.rotation() * seat.rotation().transpose()) * 180.0 / M_PI;
    EXPECT_LE(deg, 30.0 + 1e-9);
    // The face turns about a point between face and head centre, so it moves little more than the shift.
    EXPECT_LE(((other * patient->face_middle).mm - (seat * patient->face_middle).mm).norm(), 60.0 + 25.0);
    largest_deg = std::max(largest_deg, deg);
  }
  EXPECT_GT(largest_deg, 20.0);
}

TEST(OtherFace, SaysWhenThePatientIsNotThere) {
  const auto script = Played()(named("other_face"));
  std::set<std::uint64_t> people;
  for (int frame = 0; frame < script->frameCount(); ++frame) {
    const auto moment = script->at(frame);
    people.insert(moment.cast.stranger);
    EXPECT_EQ(moment.cast.stranger != 0, moment.label.rfind("another person", 0) == 0) << moment.label;
  }
  EXPECT_EQ(people.size(), 3u) << "the patient and two others";
}

TEST(Lost, ShowsEveryFaultAndSaysSo) {
  const auto script = Played()(named("lost"));
  std::set<CameraFault> faults;
  for (int frame = 0; frame < script->frameCount(); ++frame) faults.insert(script->at(frame).fault);
  EXPECT_EQ(faults.size(), 5u);
  EXPECT_EQ(script->at(0).fault, CameraFault::none);
  EXPECT_EQ(script->at(script->frameCount() - 1).label, "face in view");
}

TEST(SeatedHead, HasThePatientsRightOnTheImagesLeft) {
  const auto patient = testing::eggPatient();
  const auto room_T_mri = seatedHead(ScenarioOptions{}, *patient);
  const Eigen::Vector3d right = room_T_mri.rotation() * Eigen::Vector3d::UnitX(),
                        up = room_T_mri.rotation() * Eigen::Vector3d::UnitZ();
  EXPECT_LT(right.x(), -0.9);
  EXPECT_LT(up.y(), -0.9) << "Room's y points down";
  EXPECT_NEAR((room_T_mri * patient->face_middle).mm.z(), 600.0, 1.0);
}

TEST(LeftHandArea, LiesLeftAboveAndLooksInwards) {
  const auto patient = testing::eggPatient();
  const auto target = leftHandArea(*patient, 5.0);
  const Eigen::Vector3d from_centre = target.translation_mm() - patient->head_centre.mm;
  EXPECT_LT(from_centre.x(), -30.0) << "left is -x in RAS";
  EXPECT_GT(from_centre.z(), 30.0);
  EXPECT_LT(target.rotation().col(2).dot(from_centre.normalized()), -0.8) << "+z into the head";
  EXPECT_GT(target.rotation().col(1).y(), 0.4) << "+y away from the handle: forwards";
  EXPECT_GT(target.rotation().col(1).x(), 0.2) << "and towards the midline";
}

}  // namespace
}  // namespace facenav::room
