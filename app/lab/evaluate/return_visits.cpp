#include "evaluate/return_visits.h"

#include <cmath>

#include "evaluate/evaluation_run.h"
#include "facenav/core/robust_statistics.h"
#include "facenav/geometry/median_pose.h"
#include "facenav/geometry/pose_error.h"
#include "facenav/geometry/rotation.h"
#include "facenav/session/navigator.h"

namespace facenav::app {
namespace {

constexpr double kKnocked_deg = 0.3;   // rotation of the right camera on its mount
constexpr double kKnownDepth_mm = 25;  // depth of the cortex below the coil if there is no MRI
// Skin and pictures as in the scenario plain_align.
constexpr double kFaintSkin = 0.3, kDullGloss = 0.3;
constexpr int kWebcamJpeg = 75;

std::optional<RigidTransform<Mri, Coil>> trueCoil(const room::GroundTruth& truth) {
  if (!truth.camera_T_coil) return std::nullopt;
  return truth.camera_T_mri.inverse() * *truth.camera_T_coil;
}

/// Measures the return error: medians over the later frames.
void measureReturn(const Seen& seen, const RigidTransform<Mri, Coil>& expert,
                   const RigidTransform<Mri, Coil>& true_expert, ReturnRun& run) {
  std::vector<double> mm, deg;
  for (std::size_t i = 0; i < seen.measured.size(); ++i) {
    // True coil pose when it is measured at the expert's pose, with this frame's errors of head and coil.
    const auto truth = seen.truth[i] * seen.measured[i].inverse() * expert;
    const auto error = poseError(true_expert, truth);
    mm.push_back(error.translation_mm), deg.push_back(error.rotation_rad * kDegPerRad);
  }
  run.frames = int(mm.size());
  if (mm.empty()) return;
  run.off_mm = upperMedian(mm), run.off_deg = upperMedian(deg);
  run.p95_mm = valueAtRank(mm, std::size_t(0.95 * double(mm.size() - 1)));
  run.p95_deg = valueAtRank(deg, std::size_t(0.95 * double(deg.size() - 1)));
}

}  // namespace

room::ScenarioOptions firstVisit(std::uint64_t seed, int frames, VisitPictures pictures) {
  room::ScenarioOptions options;
  options.name = "still";
  options.seed = seed;
  options.frames = frames;
  options.seat_turn_deg = 4, options.seat_shift_mm = 15;
  options.hair_sway_mm = 3;
  options.blinks = 1;
  if (pictures == VisitPictures::plain_with_marker)
    options.skin_contrast = kFaintSkin, options.gloss = kDullGloss, options.jpeg_quality = kWebcamJpeg;
  return options;
}

std::vector<Change> laterVisits(std::uint64_t seed, int frames, VisitPictures pictures) {
  std::vector<Change> changes;
  const auto add = [&](const char* words, std::uint64_t day, auto change) {
    auto options = firstVisit(seed * 31 + day, frames, pictures);
    options.name = "treatment";
    change(options);
    changes.push_back({words, options});
  };
  add("new capture, seat, hair", 1, [](auto&) {});
  add("and another expression, light", 2,
      [](auto& o) { o.capture_grimace = 0.4, o.exposure = 0.9, o.gloss = 0.4; });
  add("and other cameras", 3, [](auto& o) {
    o.capture_grimace = 0.4, o.exposure = 1.1;
    o.rig.focal_px = 950, o.rig.baseline_mm = 150, o.rig.convergence_deg = 13, o.rig.width_px = 800,
    o.rig.height_px = 600;
    o.head_distance_mm = 640;
  });
  return changes;
}

RigidTransform<Mri, Coil> medianPose(const CoilPoses& poses) {
  std::vector<Eigen::Vector3d> centres;
  std::vector<Eigen::Matrix3d> rotations;
  for (const auto& pose : poses)
    centres.push_back(pose.translation_mm()), rotations.push_back(pose.rotation());
  return {Eigen::Quaterniond(medianRotation(rotations)), medianPoint(centres)};
}

capture::CapturePair ReturnBench::capture(room::SyntheticSource& room, VisitPictures pictures) {
  if (pictures == VisitPictures::dots) return room.capturePair();
  const auto with_coil = room.captureWithCoil();
  return {with_coil, with_coil};
}

steps::AlignmentOutcome ReturnBench::align(const cameras::StereoRig& rig, const room::SyntheticSource& room,
                                           const capture::CapturePair& pair, VisitPictures pictures,
                                           const surface::ScalpSurface& skin,
                                           const RigidTransform<Mri, Coil>& expert) const {
  guidance::Target target;
  target.name = "expert";
  target.mri_T_target = expert.reframe<Mri, frames::Target>();
  target.cortex_point = target.scalp_point = expert * Point<Coil>(0, 0, kKnownDepth_mm);
  const std::vector<guidance::Target> targets{target};
  steps::AlignmentSetup setup{skin, *aligner, *detector, targets};
  setup.coil = coilOf(room.coil());
  const bool is_plain = pictures == VisitPictures::plain_with_marker;
  if (is_plain) setup.coil_tracker = marker_finder.get();
  return steps::alignFromCapture(
      rig, pair, is_plain ? measured_face::AlignedFrom::plain : measured_face::AlignedFrom::dots, setup,
      context.monitor);
}

Seen ReturnBench::follow(room::SyntheticSource& room, const cameras::StereoRig& rig,
                         const steps::AlignmentOutcome& alignment, double least_share) const {
  session::NavigatorSetup setup;
  setup.rig = rig;
  setup.reference = alignment.reference;
  setup.camera_T_mri_at_reference = alignment.result.camera_T_mri;
  setup.coil = coilOf(room.coil());
  setup.scalp = alignment.scalp;
  setup.pace = head_tracking::Pace::patient;
  auto& methods = context.registrations;
  session::Navigator navigator(setup, methods.head_trackers.create(methods.head_trackers.defaultName()),
                               methods.coil_trackers.create(methods.coil_trackers.defaultName()));
  Seen seen;
  const auto count = room.frameCount().value_or(1);
  while (auto frame = room.next()) {
    const auto number = frame->number;
    const auto state = navigator.process(std::move(frame));
    const auto truth = trueCoil(room.truth());
    if (double(number) < least_share * double(count) || !truth || !state.camera_T_mri || !state.camera_T_coil)
      continue;
    seen.measured.push_back(state.camera_T_mri->inverse() * *state.camera_T_coil);
    seen.truth.push_back(*truth);
  }
  return seen;
}

cameras::StereoRig beforeKnock(cameras::StereoRig rig, std::uint64_t seed, Knock knock) {
  const double sign = seed % 2 ? 1 : -1;
  const Eigen::Vector3d axis =
      Eigen::Vector3d(std::sin(double(seed)), std::cos(double(seed)), 0.4).normalized();
  const Eigen::Vector3d turn_deg = knock.is_any_axis ? Eigen::Vector3d(kKnocked_deg * axis)
                                                     : Eigen::Vector3d(0, sign * knock.sideways_deg, 0);
  Eigen::Isometry3d turn = Eigen::Isometry3d::Identity();
  turn.linear() = expRotation(kRadPerDeg * turn_deg);
  rig.right_T_left = RigidTransform<RightCamera, Camera>::fromIsometry(turn * rig.right_T_left.isometry());
  return rig;
}

ReturnRun visitAgain(const ReturnBench& bench, const ReturnModel& model, const EvaluationHead& person,
                     const Change& change, const RigidTransform<Mri, Coil>& true_expert, Knock knock) {
  ReturnRun run;
  run.head = person.name, run.model = model.name, run.change = change.words;
  room::SyntheticSource room(change.options, person.patient, person.target.mri_T_target);
  const auto rig = beforeKnock(room.rig(), change.options.seed, knock);
  try {
    const auto pair = ReturnBench::capture(room, model.pictures);
    const auto alignment = bench.align(rig, room, pair, model.pictures, model.skin, model.expert);
    run.predicted_mm = alignment.predicted_tre_mm.at("expert");
    run.bound95_mm = alignment.predicted_tre_p95_mm.at("expert");
    if (!knock.is_any_axis)
      measureReturn(bench.follow(room, rig, alignment, 0.3), model.expert, true_expert, run);
  } catch (const Cancelled&) {
    throw;
  } catch (const Error& refusal) {
    run.refusal = refusal.what();
  }
  return run;
}

}  // namespace facenav::app
