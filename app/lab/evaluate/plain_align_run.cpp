#include "evaluate/plain_align_run.h"

#include <cstdio>
#include <random>

#include "evaluate/mirrored_scan.h"
#include "facenav/align/automatic_capture.h"
#include "facenav/core/processor_time.h"
#include "facenav/geometry/rigid_fit.h"
#include "facenav/geometry/rotation.h"
#include "facenav/room/synthetic_source.h"

namespace facenav::app {
namespace {

using measured_face::AlignedFrom;

constexpr double kMoved_deg = 0.3;  // rotation of the right camera on its mount
/// One way to align, with its pictures.
struct Way {
  std::string name;
  AlignedFrom from;
  capture::CapturePair pair;
  bool has_marker = false;  // the plain picture shows the coil's marker too
};

/// Data shared by all alignments of one patient.
struct Sitting {
  Context& context;
  const EvaluationHead& head;
  std::unique_ptr<registration::Aligner> aligner;
  std::shared_ptr<const face::FaceDetector> detector;
  std::vector<guidance::Target> targets;
  std::shared_ptr<room::SyntheticSource> room;
  evaluation::RunRecord names;
  evaluation::ExactDepth depth;
  cv::Mat visible;
  cameras::StereoFrame with_coil;  // same moment, coil on the target
  coil_tracking::CoilModel coil;
  std::unique_ptr<coil_tracking::CoilTracker> coil_tracker;

  steps::AlignmentSetup setup(const surface::ScalpSurface& scalp, bool is_marker_used = false) const {
    steps::AlignmentSetup all{scalp, *aligner, *detector, targets};
    all.coil = coil;
    if (is_marker_used) all.coil_tracker = coil_tracker.get();
    return all;
  }
};

using Align = std::function<steps::AlignmentOutcome()>;

/// camera_T_marker as the tracker gives it with these cameras. If it withholds the pose, the measured one
/// (second: true).
std::optional<std::pair<Eigen::Isometry3d, bool>> measuredCoil(const Sitting& sitting,
                                                               const cameras::StereoRig& rig) {
  sitting.coil_tracker->start(rig, sitting.coil);
  cameras::StereoFrame frame = sitting.with_coil;
  sitting.coil_tracker->track(frame, {});
  frame.captured.s += 0.1;  // a pair at rest counts as two frames
  const auto coil = sitting.coil_tracker->track(frame, {});
  if (coil) return std::pair{coil->camera_T_marker.isometry(), false};
  if (!coil.observation) return std::nullopt;
  const double half_mm = 0.5 * coil.observation->size_mm;
  const std::vector<Eigen::Vector3d> print_mm{
      {-half_mm, -half_mm, 0}, {half_mm, -half_mm, 0}, {half_mm, half_mm, 0}, {-half_mm, half_mm, 0}};
  std::vector<Eigen::Vector3d> seen_mm;
  for (std::size_t i = 0; i < 4; ++i)
    seen_mm.push_back(
        cameras::triangulate(rig, coil.observation->left_px[i], coil.observation->right_px[i]).mm);
  return std::pair{fitRigidPoints(print_mm, seen_mm).to_T_from, true};
}

/// Records the distance between the shown and the true target under the coil.
void noteCoil(const Sitting& sitting, const cameras::StereoRig& rig,
              const registration::AlignmentResult& result, evaluation::AlignmentRecord& record) {
  const auto measured = measuredCoil(sitting, rig);
  if (!measured) return;
  const auto& target = sitting.targets.front();
  const Eigen::Isometry3d mri_T_marker =
      target.mri_T_target.isometry() * sitting.coil.markers.front().coil_T_marker.isometry();
  const Eigen::Vector3d shown_mm = result.camera_T_mri.isometry().inverse() * measured->first *
                                   mri_T_marker.inverse() * target.cortex_point.mm;
  record.coil_mm = (shown_mm - target.cortex_point.mm).norm();
  record.is_coil_withheld = measured->second;
  record.coil_bound95_mm =
      result.coilErrorBound_mm(target.cortex_point, steps::markerAt(target, sitting.coil));
}

evaluation::RunRecord recordOf(const Sitting& sitting, const std::string& from, const cameras::StereoRig& rig,
                               const Align& align) {
  evaluation::RunRecord run = sitting.names;
  run.from = from;
  const auto& target = sitting.targets.front();
  run.target_mm = target.cortex_point.mm;
  run.true_reference = sitting.room->captureTruth().isometry();
  run.alignment.emplace();
  auto& record = *run.alignment;
  const double start_ms = processorTime_ms();
  try {
    const auto outcome = align();
    record.measure_ms = processorTime_ms() - start_ms;
    record.estimated = outcome.result.camera_T_mri.isometry();
    record.truth = run.true_reference;
    record.predicted_mm = outcome.result.predictedError_mm(target.cortex_point);
    record.bound95_mm = outcome.result.errorBound_mm(target.cortex_point);
    record.rms_mm = outcome.result.rms_mm;
    noteCoil(sitting, rig, outcome.result, record);
    if (outcome.result.right_turn) {
      record.turn_deg = kDegPerRad * outcome.result.right_turn->rad;
      record.turn_sigma_deg = kDegPerRad * outcome.result.right_turn->sigma_rad;
    }
    run.cloud = evaluation::evaluateCloud(sitting.room->rig(), outcome.face, sitting.depth, sitting.visible);
  } catch (const Cancelled&) {
    throw;
  } catch (const Error& refusal) {
    record.refusal = refusal.what();
  }
  return run;
}

/// Picture with the coil that automatic capture takes; the first one if it takes none.
cameras::StereoFrame takenByItself(const Sitting& sitting, const Methods& methods) {
  constexpr int kMostPictures = 12;
  constexpr double kFrames_per_s = 30.0;
  auto& room = *sitting.room;
  steps::AutomaticCapture still(
      room.rig(), {sitting.detector, sitting.context.registrations.coil_trackers.create(methods.coil_tracker),
                   sitting.coil});
  for (int i = 0; i < kMostPictures; ++i) {
    cameras::StereoFrame frame = room.captureWithCoil(i);
    frame.captured = Timestamp{i / kFrames_per_s};
    if (still.add(frame)) return still.still();
  }
  return room.captureWithCoil();
}

/// The calibration before the right camera was rotated about an axis drawn from the seed.
cameras::StereoRig beforeAKnock(cameras::StereoRig rig, std::uint64_t seed) {
  std::mt19937_64 random(seed * 977 + 5);
  std::normal_distribution<double> normal;
  const Eigen::Vector3d axis = Eigen::Vector3d(normal(random), normal(random), normal(random)).normalized();
  Eigen::Isometry3d turn = Eigen::Isometry3d::Identity();
  turn.linear() = expRotation(kMoved_deg * kRadPerDeg * axis);
  rig.right_T_left = RigidTransform<RightCamera, Camera>::fromIsometry(turn * rig.right_T_left.isometry());
  return rig;
}

/// The calibration before the right camera was rotated about its vertical axis, which matches cannot show.
cameras::StereoRig beforeATurn(cameras::StereoRig rig, double turn_deg) {
  Eigen::Isometry3d turn = Eigen::Isometry3d::Identity();
  turn.linear() = expRotation(-turn_deg * kRadPerDeg * Eigen::Vector3d::UnitY());
  rig.right_T_left = RigidTransform<RightCamera, Camera>::fromIsometry(turn * rig.right_T_left.isometry());
  return rig;
}

/// Adds runs with a rotated camera. Each must be refused, corrected, or lie inside its bound.
void addTurned(const Sitting& sitting, const std::vector<Way>& ways,
               std::vector<evaluation::RunRecord>& runs) {
  const double sign = sitting.names.seed % 2 ? 1.0 : -1.0;
  for (const double turn_deg : {0.05, 0.1, 0.2, 0.3})
    for (const auto& way : ways) {
      const auto rig = beforeATurn(sitting.room->rig(), sign * turn_deg);
      char name[64];
      std::snprintf(name, sizeof name, "%s: turned sideways by %.2f deg", way.name.c_str(), sign * turn_deg);
      runs.push_back(recordOf(sitting, name, rig, [&] {
        return steps::alignFromCapture(rig, way.pair, way.from,
                                       sitting.setup(sitting.head.scalp, way.has_marker),
                                       sitting.context.monitor);
      }));
    }
}

void addRefusals(const Sitting& sitting, const capture::CapturePair& pair, const surface::ScalpSurface* other,
                 std::vector<evaluation::RunRecord>& runs) {
  const auto attempt = [&](AlignedFrom from, const std::string& what, const cameras::StereoRig& rig,
                           const surface::ScalpSurface& scalp) {
    runs.push_back(recordOf(sitting, std::string(nameOf(from)) + ": " + what, rig, [&] {
      return steps::alignFromCapture(rig, pair, from, sitting.setup(scalp), sitting.context.monitor);
    }));
    runs.back().must_be_refused = true;
  };
  const auto& rig = sitting.room->rig();
  if (other) attempt(AlignedFrom::plain, "another's scan", rig, *other);
  attempt(AlignedFrom::plain, "mirrored scan", rig, mirrored(sitting.head.scalp));
  for (const auto from : {AlignedFrom::plain, AlignedFrom::dots})
    attempt(from, "camera turned by 0.3 deg", beforeAKnock(rig, sitting.names.seed), sitting.head.scalp);
}

}  // namespace

std::vector<evaluation::RunRecord> runPlainAlign(Context& context, const room::ScenarioOptions& options,
                                                 const EvaluationHead& head,
                                                 const surface::ScalpSurface* other, const Methods& methods,
                                                 const evaluation::RunRecord& names, AlignTries tries) {
  Sitting sitting{context,
                  head,
                  context.registrations.aligners.create(methods.aligner),
                  context.registrations.face_detector(),
                  {head.target},
                  std::make_shared<room::SyntheticSource>(options, head.patient, head.target.mri_T_target),
                  names,
                  {},
                  {},
                  {},
                  {},
                  context.registrations.coil_trackers.create(methods.coil_tracker)};
  room::SyntheticSource& room = *sitting.room;
  const capture::CapturePair dense = room.capturePair();
  capture::CapturePair sparse{room.captureWith(stereo::DotPattern::sparse), dense.plain},
      plain{dense.plain, dense.plain};
  sitting.coil = coilOf(room.coil());
  sitting.with_coil = takenByItself(sitting, methods);
  room.captureWith(std::nullopt);  // because the room's depth is that of the last picture
  const room::DepthMaps depth = room.depth();
  sitting.depth = {depth.left_mm, depth.right_mm, depth.left_object == 1};
  sitting.visible =
      evaluation::visibleFace(room.rig(), sitting.depth, room.captureTruth() * head.patient->face_middle);
  std::vector<evaluation::RunRecord> runs;
  const std::vector<Way> ways{
      {"dots", AlignedFrom::dots, dense},
      {"dots and marker", AlignedFrom::dots, {dense.pattern, sitting.with_coil}, true},
      {"sparse dots", AlignedFrom::dots, sparse},
      {"plain", AlignedFrom::plain, plain},
      {"plain and marker", AlignedFrom::plain, {sitting.with_coil, sitting.with_coil}, true}};
  for (const auto& way : ways)
    runs.push_back(recordOf(sitting, way.name, room.rig(), [&] {
      return steps::alignFromCapture(room.rig(), way.pair, way.from,
                                     sitting.setup(head.scalp, way.has_marker), context.monitor);
    }));
  if (room.frameCount().value_or(0) > 1)
    runs.push_back(recordOf(sitting, "film", room.rig(), [&] {
      const auto tracker = context.registrations.head_trackers.create(methods.head_tracker);
      return steps::alignFromFilm(room, 0, *room.frameCount() - 1, *tracker, sitting.setup(head.scalp),
                                  context.monitor);
    }));
  if (tries != AlignTries::right) {
    addTurned(sitting, ways, runs);
    addRefusals(sitting, dense, other, runs);
  }
  return runs;
}

}  // namespace facenav::app
