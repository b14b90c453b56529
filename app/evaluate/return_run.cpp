#include "evaluate/return_run.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "facenav/core/number_text.h"
#include "facenav/core/robust_statistics.h"
#include "facenav/geometry/median_pose.h"
#include "facenav/geometry/pose_error.h"
#include "facenav/geometry/rotation.h"
#include "facenav/room/synthetic_source.h"
#include "facenav/session/navigator.h"
#include "facenav/workflow/face_model.h"

namespace facenav::app {
namespace {

using CoilPoses = std::vector<RigidTransform<Mri, Coil>>;

constexpr double kMoved_deg = 0.3;     // of the right camera on its mount
constexpr double kKnownDepth_mm = 25;  // of the cortex below the coil, where no MRI says it

/// A visit that differs from the first.
struct Change {
  const char* words;
  room::ScenarioOptions options;
};

room::ScenarioOptions firstVisit(std::uint64_t seed, int frames) {
  room::ScenarioOptions options;
  options.name = "still";
  options.seed = seed;
  options.frames = frames;
  options.seat_turn_deg = 4, options.seat_shift_mm = 15;
  options.hair_sway_mm = 3;
  options.blinks = 1;
  return options;
}

std::vector<Change> laterVisits(std::uint64_t seed, int frames) {
  std::vector<Change> changes;
  const auto add = [&](const char* words, std::uint64_t day, auto change) {
    auto options = firstVisit(seed * 31 + day, frames);
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

/// What a visit saw: the coil as measured and as it truly was, in step.
struct Seen {
  CoilPoses measured, truth;
};

std::optional<RigidTransform<Mri, Coil>> trueCoil(const room::GroundTruth& truth) {
  if (!truth.camera_T_coil) return std::nullopt;
  return truth.camera_T_mri.inverse() * *truth.camera_T_coil;
}

Seen follow(Context& context, room::SyntheticSource& room, const workflow::AlignmentOutcome& alignment,
            double least_share) {
  session::NavigatorSetup setup;
  setup.rig = room.rig();
  setup.reference = alignment.reference;
  setup.camera_T_mri_at_reference = alignment.result.camera_T_mri;
  setup.coil.name = room.coil().name;
  coil_tracking::MarkerModel marker;
  marker.dictionary = room.coil().dictionary, marker.id = room.coil().marker_id;
  marker.size_mm = room.coil().marker_size_mm;
  marker.coil_T_marker = room.coil().marker_T_coil.inverse();
  setup.coil.markers = {marker};
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

RigidTransform<Mri, Coil> medianPose(const CoilPoses& poses) {
  std::vector<Eigen::Vector3d> centres;
  std::vector<Eigen::Matrix3d> rotations;
  for (const auto& pose : poses)
    centres.push_back(pose.translation_mm()), rotations.push_back(pose.rotation());
  return {Eigen::Quaterniond(medianRotation(rotations)), medianPoint(centres)};
}

/// The skin that a later visit aligns to, and the expert's pose in its frame.
struct ReturnModel {
  std::string name;
  surface::ScalpSurface skin;
  RigidTransform<Mri, Coil> expert;
};

struct ReturnBench {
  Context& context;
  std::unique_ptr<registration::Aligner> aligner;
  std::shared_ptr<const face::FaceDetector> detector;

  workflow::AlignmentOutcome align(const cameras::StereoRig& rig, const capture::CapturePair& pair,
                                   const surface::ScalpSurface& skin, const Point<Mri>& at) const {
    guidance::Target target;
    target.name = "expert";
    target.cortex_point = target.scalp_point = at;
    const std::vector<guidance::Target> targets{target};
    return workflow::alignFromCapture(rig, pair, workflow::AlignedFrom::dots,
                                      {skin, *aligner, *detector, targets}, context.monitor);
  }
};

/// Later frames, medians over them.
void measureReturn(const Seen& seen, const RigidTransform<Mri, Coil>& expert,
                   const RigidTransform<Mri, Coil>& true_expert, ReturnRun& run) {
  std::vector<double> mm, deg;
  for (std::size_t i = 0; i < seen.measured.size(); ++i) {
    // Where the coil truly is when it reads as the expert's pose, with this frame's errors of head and coil.
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

cameras::StereoRig afterAKnock(cameras::StereoRig rig, std::uint64_t seed) {
  const Eigen::Vector3d axis =
      Eigen::Vector3d(std::sin(double(seed)), std::cos(double(seed)), 0.4).normalized();
  Eigen::Isometry3d turn = Eigen::Isometry3d::Identity();
  turn.linear() = expRotation(kMoved_deg * kRadPerDeg * axis);
  rig.right_T_left = RigidTransform<RightCamera, Camera>::fromIsometry(turn * rig.right_T_left.isometry());
  return rig;
}

/// The first visit: the expert holds the coil at the target.
std::vector<ReturnModel> modelsOf(const ReturnBench& bench, const EvaluationHead& head, std::uint64_t seed,
                                  int frames, RigidTransform<Mri, Coil>& true_expert) {
  auto options = firstVisit(seed, frames);
  options.name = "treatment";
  room::SyntheticSource room(options, head.patient, head.target.mri_T_target);
  const auto pair = room.capturePair();
  const auto alignment = bench.align(room.rig(), pair, head.scalp, head.target.cortex_point);
  const auto& camera_T_mri = alignment.result.camera_T_mri;
  workflow::FaceModelSetup of_mri{*bench.detector};
  of_mri.camera_T_mri = camera_T_mri;
  of_mri.scalp = alignment.scalp.get();
  const auto in_mri = workflow::measureFaceModel(room.rig(), pair, of_mri, bench.context.monitor);
  const auto alone = workflow::measureFaceModel(room.rig(), pair, {*bench.detector}, bench.context.monitor);
  const Seen seen = follow(bench.context, room, alignment, 0.8);  // at the end the coil rests on the target
  if (seen.measured.empty()) throw Error("the first visit saw no coil", head.name);
  const auto expert = medianPose(seen.measured);
  true_expert = medianPose(seen.truth);
  const auto own_T_mri = alone.camera_T_mri.inverse() * camera_T_mri;  // both name their frame Mri
  return {{"MRI", head.scalp, expert},
          {"face in the MRI's frame", in_mri.skin, expert},
          {"face alone", alone.skin, own_T_mri * expert}};
}

ReturnRun visit(const ReturnBench& bench, const ReturnModel& model, const EvaluationHead& person,
                const Change& change, const RigidTransform<Mri, Coil>& true_expert, bool is_knocked) {
  ReturnRun run;
  run.head = person.name, run.model = model.name, run.change = change.words;
  room::SyntheticSource room(change.options, person.patient, person.target.mri_T_target);
  const auto rig = is_knocked ? afterAKnock(room.rig(), change.options.seed) : room.rig();
  const Point<Mri> at = model.expert * Point<Coil>(0, 0, kKnownDepth_mm);
  try {
    const auto alignment = bench.align(rig, room.capturePair(), model.skin, at);
    run.predicted_mm = alignment.result.predictedError_mm(at);
    run.bound95_mm = alignment.result.errorBound_mm(at);
    if (!is_knocked)
      measureReturn(follow(bench.context, room, alignment, 0.3), model.expert, true_expert, run);
  } catch (const Cancelled&) {
    throw;
  } catch (const Error& refusal) {
    run.refusal = refusal.what();
  }
  return run;
}

std::string summaryRow(const std::string& model, const std::vector<const ReturnRun*>& runs) {
  std::vector<double> mm, deg;
  int refused = 0, inside = 0, met = 0;
  for (const auto* run : runs) {
    if (!run->refusal.empty() || run->frames == 0) {
      ++refused;
      continue;
    }
    mm.push_back(run->off_mm), deg.push_back(run->off_deg);
    inside += run->off_mm <= run->bound95_mm;
    met += run->off_mm <= 1 && run->off_deg <= 1;
  }
  if (mm.empty()) return formatted("| %s | all %d refused | | | | |\n", model.c_str(), refused);
  return formatted("| %s | %.2f mm, %.2f deg | %.2f mm, %.2f deg | %d of %zu | %d of %zu | %d |\n",
                   model.c_str(), upperMedian(mm), upperMedian(deg), *std::max_element(mm.begin(), mm.end()),
                   *std::max_element(deg.begin(), deg.end()), met, mm.size(), inside, mm.size(), refused);
}

}  // namespace

std::vector<ReturnRun> runReturns(Context& context, const EvaluationHead& head, const EvaluationHead* other,
                                  const ReturnRequest& request) {
  const auto& aligners = context.registrations.aligners;
  const ReturnBench bench{context, aligners.create(aligners.defaultName()),
                          context.registrations.face_detector()};
  std::vector<ReturnRun> runs;
  for (const std::uint64_t seed : request.seeds) {
    RigidTransform<Mri, Coil> true_expert;
    const auto models = modelsOf(bench, head, seed, request.frames, true_expert);
    const auto changes = laterVisits(seed, request.frames);
    const auto add = [&](ReturnRun run, bool must_be_refused, const char* what) {
      run.seed = seed, run.must_be_refused = must_be_refused;
      if (what) run.change = what;
      runs.push_back(std::move(run));
    };
    for (const auto& model : models) {
      for (const auto& change : changes) {
        context.monitor.report("returns: " + head.name + ", " + model.name, 0.0);
        add(visit(bench, model, head, change, true_expert, false), false, nullptr);
      }
      add(visit(bench, model, head, changes.front(), true_expert, true), true, "a camera turned by 0.3 deg");
      if (other)
        add(visit(bench, model, *other, changes.front(), true_expert, false), true, "another person");
    }
  }
  return runs;
}

std::string returnsTable(const std::vector<ReturnRun>& runs) {
  std::map<std::string, std::vector<const ReturnRun*>> by_model, by_change;
  std::string refusals;
  for (const auto& run : runs) {
    if (run.must_be_refused) continue;
    by_model[run.model].push_back(&run);
    by_change[run.model + ": " + run.change].push_back(&run);
  }
  std::map<std::string, std::pair<int, int>> refused;
  for (const auto& run : runs)
    if (run.must_be_refused) {
      auto& [yes, all] = refused[run.model + ": " + run.change];
      yes += !run.refusal.empty(), ++all;
    }
  std::string text =
      "| model | median | largest | within 1 mm and 1 deg | inside the 95 % bound | refused "
      "|\n|---|---|---|---|---|---|\n";
  for (const auto& [model, group] : by_model) text += summaryRow(model, group);
  for (const auto& [change, group] : by_change) text += summaryRow(change, group);
  text += "\n| must be refused | was |\n|---|---|\n";
  for (const auto& [what, count] : refused)
    text += formatted("| %s | %d of %d |\n", what.c_str(), count.first, count.second);
  return text;
}

std::string returnsCsv(const std::vector<ReturnRun>& runs) {
  std::string csv =
      "head,model,change,seed,must_be_refused,refusal,frames,off_mm,off_deg,p95_mm,p95_deg,predicted_mm,"
      "bound95_mm\n";
  for (const auto& run : runs) {
    std::string refusal = run.refusal;
    std::replace(refusal.begin(), refusal.end(), '"', '\'');
    csv += run.head + "," + run.model + ",\"" + run.change + "\"," + std::to_string(run.seed) +
           (run.must_be_refused ? ",1," : ",0,") + "\"" + refusal + "\"" +
           formatted(",%d,%.4f,%.4f,%.4f,%.4f,%.4f,%.4f\n", run.frames, run.off_mm, run.off_deg, run.p95_mm,
                     run.p95_deg, run.predicted_mm, run.bound95_mm);
  }
  return csv;
}

}  // namespace facenav::app
