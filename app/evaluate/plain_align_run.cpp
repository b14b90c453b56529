#include "evaluate/plain_align_run.h"

#include <cstdio>
#include <random>

#include "facenav/core/processor_time.h"
#include "facenav/geometry/rotation.h"
#include "facenav/room/synthetic_source.h"

namespace facenav::app {
namespace {

using workflow::AlignedFrom;

constexpr double kMoved_deg = 0.3;  // of the right camera on its mount

/// What is common to all alignments of one patient.
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

  workflow::AlignmentSetup setup(const surface::ScalpSurface& scalp) const {
    return {scalp, *aligner, *detector, targets};
  }
};

using Align = std::function<workflow::AlignmentOutcome()>;

evaluation::RunRecord recordOf(const Sitting& sitting, const std::string& from, const Align& align) {
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

/// The scan with left and right exchanged.
surface::ScalpSurface mirrored(surface::ScalpSurface scalp) {
  for (auto& p : scalp.mesh.vertices_mm) p.x() = -p.x();
  for (auto& n : scalp.mesh.normals) n.x() = -n.x();
  for (auto& triangle : scalp.mesh.triangles) std::swap(triangle[1], triangle[2]);
  for (auto& [point, normal] : scalp.field_of_view)
    point.mm.x() = -point.mm.x(), normal.v.x() = -normal.v.x();
  return scalp;
}

/// The calibration from before the right camera was turned, about an axis that the seed draws.
cameras::StereoRig beforeAKnock(cameras::StereoRig rig, std::uint64_t seed) {
  std::mt19937_64 random(seed * 977 + 5);
  std::normal_distribution<double> normal;
  const Eigen::Vector3d axis = Eigen::Vector3d(normal(random), normal(random), normal(random)).normalized();
  Eigen::Isometry3d turn = Eigen::Isometry3d::Identity();
  turn.linear() = expRotation(kMoved_deg * kRadPerDeg * axis);
  rig.right_T_left = RigidTransform<RightCamera, Camera>::fromIsometry(turn * rig.right_T_left.isometry());
  return rig;
}

/// The calibration from before the right camera turned about its vertical axis, which no match shows.
cameras::StereoRig beforeATurn(cameras::StereoRig rig, double turn_deg) {
  Eigen::Isometry3d turn = Eigen::Isometry3d::Identity();
  turn.linear() = expRotation(-turn_deg * kRadPerDeg * Eigen::Vector3d::UnitY());
  rig.right_T_left = RigidTransform<RightCamera, Camera>::fromIsometry(turn * rig.right_T_left.isometry());
  return rig;
}

/// Each must be refused, corrected, or lie inside its stated bound.
void addTurned(const Sitting& sitting, const std::vector<std::pair<std::string, capture::CapturePair>>& ways,
               std::vector<evaluation::RunRecord>& runs) {
  const double sign = sitting.names.seed % 2 ? 1.0 : -1.0;
  for (const double turn_deg : {0.05, 0.1, 0.2, 0.3})
    for (const auto& [way, pair] : ways) {
      const auto from = way == "plain" ? AlignedFrom::plain : AlignedFrom::dots;
      char name[64];
      std::snprintf(name, sizeof name, "%s: turned sideways by %.2f deg", way.c_str(), sign * turn_deg);
      runs.push_back(recordOf(sitting, name, [&, pair = pair] {
        return workflow::alignFromCapture(beforeATurn(sitting.room->rig(), sign * turn_deg), pair, from,
                                          sitting.setup(sitting.head.scalp), sitting.context.monitor);
      }));
    }
}

void addRefusals(const Sitting& sitting, const capture::CapturePair& pair, const surface::ScalpSurface* other,
                 std::vector<evaluation::RunRecord>& runs) {
  const auto attempt = [&](AlignedFrom from, const std::string& what, const cameras::StereoRig& rig,
                           const surface::ScalpSurface& scalp) {
    runs.push_back(recordOf(sitting, std::string(nameOf(from)) + ": " + what, [&] {
      return workflow::alignFromCapture(rig, pair, from, sitting.setup(scalp), sitting.context.monitor);
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
                                                 const evaluation::RunRecord& names) {
  Sitting sitting{context,
                  head,
                  context.registrations.aligners.create(methods.aligner),
                  context.registrations.face_detector(),
                  {head.target},
                  std::make_shared<room::SyntheticSource>(options, head.patient, head.target.mri_T_target),
                  names,
                  {},
                  {}};
  room::SyntheticSource& room = *sitting.room;
  capture::CapturePair dense = room.capturePair();
  capture::CapturePair sparse{room.captureWith(stereo::DotPattern::sparse), dense.plain},
      plain{dense.plain, dense.plain};
  const room::DepthMaps depth = room.depth();
  sitting.depth = {depth.left_mm, depth.right_mm, depth.left_object == 1};
  sitting.visible =
      evaluation::visibleFace(room.rig(), sitting.depth, room.captureTruth() * head.patient->face_middle);
  std::vector<evaluation::RunRecord> runs;
  for (const auto& [from, pair] : {std::pair{"dots", &dense}, {"sparse dots", &sparse}, {"plain", &plain}})
    runs.push_back(recordOf(sitting, from, [&, pair = pair] {
      const AlignedFrom kind = pair == &plain ? AlignedFrom::plain : AlignedFrom::dots;
      return workflow::alignFromCapture(room.rig(), *pair, kind, sitting.setup(head.scalp), context.monitor);
    }));
  if (room.frameCount().value_or(0) > 1)
    runs.push_back(recordOf(sitting, "film", [&] {
      const auto tracker = context.registrations.head_trackers.create(methods.head_tracker);
      return workflow::alignFromFilm(room, 0, *room.frameCount() - 1, *tracker, sitting.setup(head.scalp),
                                     context.monitor);
    }));
  addTurned(sitting, {{"dots", dense}, {"sparse dots", sparse}, {"plain", plain}}, runs);
  addRefusals(sitting, dense, other, runs);
  return runs;
}

}  // namespace facenav::app
