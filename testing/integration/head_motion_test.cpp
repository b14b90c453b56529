// Accuracy of the head's motion in the most difficult cases, on short seeded films of the virtual room: dark
// skin, and Colin27's smooth face that ends at mid-nose, turning to the side. Then the same heads, first seen
// turned, without frames in between.

#include <gtest/gtest.h>

#include <cmath>

#include "facenav/volume/nifti.h"
#include "support/room_film.h"
#include "support/test_data.h"

namespace facenav::testing {
namespace {

constexpr double kWrong_mm = 3.0;

struct Patient {
  const char* name;
  std::filesystem::path mri;
  double skin_brightness;
  std::uint64_t seed;
  double focal_px, baseline_mm;
};

class HeadMotion : public ::testing::TestWithParam<Patient> {};

RoomFilm turning(const Patient& head, const face::FaceDetector& detector) {
  TaskMonitor monitor;
  room::PatientOptions skin;
  skin.skin_brightness = head.skin_brightness, skin.seed = head.seed;
  room::ScenarioOptions options;
  options.name = "free_motion";
  options.frames = 20, options.frames_per_s = 16, options.seed = head.seed;
  options.rig.focal_px = head.focal_px, options.rig.baseline_mm = head.baseline_mm;
  return filmed(options,
                std::make_shared<const room::VirtualPatient>(
                    room::makePatient(volume::readNifti(head.mri).volume, skin, monitor)),
                detector);
}

TEST_P(HeadMotion, IsHeldWithinThreeTenthsOfAMillimetreAndFoundFromTheSide) {
  FACENAV_NEEDS(GetParam().mri);
  const std::shared_ptr<const face::FaceDetector> detector = face::makeFaceDetector();
  const RoomFilm film = turning(GetParam(), *detector);
  const auto tracker = head_tracking::makeModelHeadTracker(detector);
  tracker->start(film.rig, film.reference);
  double squares_mm2 = 0;
  int tracked = 0;
  for (std::size_t i = 0; i < film.frames.size(); ++i)
    if (const auto pose = tracker->track(*film.frames[i])) {
      const double error_mm = film.errorAtTarget_mm(*pose, i);
      EXPECT_LT(error_mm, kWrong_mm) << i;
      squares_mm2 += error_mm * error_mm, ++tracked;
    }
  EXPECT_GE(tracked, int(film.frames.size()) - 1);
  EXPECT_LT(std::sqrt(squares_mm2 / std::max(1, tracked)), 0.3);

  for (const std::size_t first : {film.frames.size() / 2, film.frames.size() - 4}) {
    std::size_t i = first;
    while (i < film.frames.size()) {
      if (const auto pose = tracker->track(*film.frames[i], {{}, i == first})) {
        EXPECT_LT(film.errorAtTarget_mm(*pose, i), kWrong_mm) << i;
        break;
      }
      ++i;
    }
    EXPECT_LT(i, first + 4) << "not found within 0.2 s, from " << first;
  }
}

INSTANTIATE_TEST_SUITE_P(Room, HeadMotion,
                         ::testing::Values(Patient{"Dark", virtualPatientMri(), 0.35, 43, 914, 124},
                                           Patient{"Colin27", colin27(), 1.0, 21, 800, 120}),
                         [](const auto& head) { return std::string(head.param.name); });

// Free-running cameras are not triggered together. Without correction, 12 ms cause an error of a millimetre
// and half a degree here.
TEST(FreeRunningCameras, AreKnownByTheMovingHeadAndAllowedFor) {
  FACENAV_NEEDS(virtualPatientMri());
  TaskMonitor monitor;
  room::ScenarioOptions options;
  options.name = "free_motion";
  options.frames = 32, options.seed = 3, options.motion = 1.5;
  options.right_late_ms = 12.0;
  const std::shared_ptr<const face::FaceDetector> detector = face::makeFaceDetector();
  const RoomFilm film = filmed(options,
                               std::make_shared<const room::VirtualPatient>(room::makePatient(
                                   volume::readNifti(virtualPatientMri()).volume, {}, monitor)),
                               *detector);
  const auto tracker = head_tracking::makeModelHeadTracker(detector);
  tracker->start(film.rig, film.reference);
  double squares_mm2 = 0, right_late_s = 0;
  constexpr std::size_t kKnown = 20;
  for (std::size_t i = 0; i < film.frames.size(); ++i) {
    const auto pose = tracker->track(*film.frames[i]);
    ASSERT_TRUE(pose) << i;
    right_late_s = pose.exposure_offset.right_late_s;
    if (i >= kKnown) squares_mm2 += std::pow(film.errorAtTarget_mm(*pose, i), 2);
  }
  EXPECT_LT(std::sqrt(squares_mm2 / double(film.frames.size() - kKnown)), 0.35);
  EXPECT_NEAR(1e3 * right_late_s, 12.0, 1.0);
}

}  // namespace
}  // namespace facenav::testing
