#include "evaluate/return_run.h"

#include <functional>

#include "evaluate/evaluation_run.h"
#include "evaluate/return_visits.h"
#include "facenav/align/face_model.h"
#include "facenav/align/known_lengths.h"
#include "facenav/core/error.h"
#include "facenav/core/number_text.h"

namespace facenav::app {
namespace {

using measured_face::AlignedFrom;

constexpr const char* kFirstVisit = "first visit";
constexpr double kSideways_deg[] = {0.05, 0.1};  // rotations of the right camera that matches cannot show

/// Models of the first visit with a projector: the expert holds the coil at the target.
std::vector<ReturnModel> dottedModels(const ReturnBench& bench, const EvaluationHead& head,
                                      std::uint64_t seed, int frames,
                                      RigidTransform<Mri, Coil>& true_expert) {
  auto options = firstVisit(seed, frames, VisitPictures::dots);
  options.name = "treatment";
  room::SyntheticSource room(options, head.patient, head.target.mri_T_target);
  const auto pair = room.capturePair();
  const auto at_target = head.target.mri_T_target.reframe<Mri, Coil>();
  const auto alignment = bench.align(room.rig(), room, pair, VisitPictures::dots, head.scalp, at_target);
  const auto& camera_T_mri = alignment.result.camera_T_mri;
  steps::FaceModelSetup of_mri{*bench.detector};
  of_mri.camera_T_mri = camera_T_mri;
  of_mri.scalp = alignment.scalp.get();
  of_mri.size_error = alignment.faceSizeError();
  const auto measure = [&](const steps::FaceModelSetup& setup) {
    return steps::measureFaceModel(room.rig(), pair, AlignedFrom::dots, setup, bench.context.monitor);
  };
  const auto in_mri = measure(of_mri);
  const auto alone = measure({*bench.detector});
  // At the end the coil rests on the target.
  const Seen seen = bench.follow(room, room.rig(), alignment, 0.8);
  if (seen.measured.empty()) throw Error("the first visit saw no coil", head.name);
  const auto expert = medianPose(seen.measured);
  true_expert = medianPose(seen.truth);
  const auto own_T_mri = alone.camera_T_mri.inverse() * camera_T_mri;  // both frames are called Mri
  return {{"MRI", head.scalp, expert},
          {"face in the MRI's frame", in_mri.skin, expert},
          {"face alone", alone.skin, own_T_mri * expert},
          {"face in the MRI's frame, then plain pictures", in_mri.skin, expert,
           VisitPictures::plain_with_marker}};
}

/// First visit without a projector, with the marker in its pictures.
struct PlainVisit {
  std::unique_ptr<room::SyntheticSource> room, film;
  cameras::StereoRig rig;
  capture::CapturePair pair;
  steps::FaceModelSetup alone;
};

PlainVisit plainVisit(const ReturnBench& bench, const EvaluationHead& head, std::uint64_t seed, int frames,
                      Knock knock) {
  auto options = firstVisit(seed, frames, VisitPictures::plain_with_marker);
  options.name = "treatment";
  auto turning = options;
  turning.name = room::kPlainAlign, turning.frames = 0, turning.frames_per_s = 20;
  const auto roomOf = [&](const room::ScenarioOptions& its) {
    return std::make_unique<room::SyntheticSource>(its, head.patient, head.target.mri_T_target);
  };
  PlainVisit visit{roomOf(options), roomOf(turning), {}, {}, {*bench.detector}};
  visit.rig = beforeKnock(visit.room->rig(), seed, knock);
  visit.pair = ReturnBench::capture(*visit.room, VisitPictures::plain_with_marker);
  const auto marker =
      steps::markerInPair(visit.rig, visit.pair.plain, coilOf(visit.room->coil()), *bench.marker_finder);
  visit.alone.marker = marker.length;
  return visit;
}

steps::FaceModel filmedFace(const ReturnBench& bench, PlainVisit& visit) {
  const auto& trackers = bench.context.registrations.head_trackers;
  const auto tracker = trackers.create(trackers.defaultName());
  return steps::measureFaceModel(*visit.film, 0, visit.film->frameCount().value_or(1) - 1, *tracker,
                                 visit.alone, bench.context.monitor);
}

/// Runs `task`; records a refusal as a run, too.
void orRefused(const std::string& head, const std::string& model, const std::string& change,
               std::uint64_t seed, std::vector<ReturnRun>& runs, const std::function<void()>& task) {
  try {
    task();
  } catch (const Cancelled&) {
    throw;
  } catch (const Error& refusal) {
    ReturnRun run;
    run.head = head, run.model = model, run.change = change, run.seed = seed;
    run.refusal = refusal.what();
    runs.push_back(run);
  }
}

/// Models of first visits without a projector. Each model's expert pose is that of a session aligned to it
/// from the plain pair. Faces that are not measured go into `refused`.
std::vector<ReturnModel> plainModels(const ReturnBench& bench, const EvaluationHead& head, std::uint64_t seed,
                                     int frames, Knock knock, RigidTransform<Mri, Coil>& true_expert,
                                     std::vector<ReturnRun>& refused) {
  auto visit = plainVisit(bench, head, seed, frames, knock);
  const auto at_target = head.target.mri_T_target.reframe<Mri, Coil>();
  const auto align = [&](const surface::ScalpSurface& skin) {
    return bench.align(visit.rig, *visit.room, visit.pair, VisitPictures::plain_with_marker, skin, at_target);
  };
  const auto by_mri = align(head.scalp);
  const Seen seen = bench.follow(*visit.room, visit.rig, by_mri, 0.8);
  if (seen.measured.empty()) throw Error("the first visit saw no coil", head.name);
  const auto expert = medianPose(seen.measured);
  true_expert = medianPose(seen.truth);
  std::vector<ReturnModel> models;
  const auto add = [&](const char* name, const surface::ScalpSurface& skin,
                       const RigidTransform<Mri, Coil>& pose) {
    models.push_back({name, skin, pose, VisitPictures::plain_with_marker});
  };
  steps::FaceModelSetup of_mri{*bench.detector};
  of_mri.camera_T_mri = by_mri.result.camera_T_mri;
  of_mri.scalp = by_mri.scalp.get();
  of_mri.size_error = by_mri.faceSizeError();
  const auto measure = [&](const steps::FaceModelSetup& setup) {
    return steps::measureFaceModel(visit.rig, visit.pair, AlignedFrom::plain, setup, bench.context.monitor);
  };
  add("MRI, plain pictures", head.scalp, expert);
  add("plain face in the MRI's frame", measure(of_mri).skin, expert);
  orRefused(head.name, "plain face alone", kFirstVisit, seed, refused, [&] {
    const auto plain = measure(visit.alone);
    add("plain face alone", plain.skin, plain.camera_T_mri.inverse() * by_mri.result.camera_T_mri * expert);
  });
  if (knock.sideways_deg != 0) return models;  // the film's calibration is that of its own room
  orRefused(head.name, "filmed face alone", kFirstVisit, seed, refused, [&] {
    const auto film = filmedFace(bench, visit);
    const auto by_film = align(film.skin);
    add("filmed face alone", film.skin,
        by_film.result.camera_T_mri.inverse() * by_mri.result.camera_T_mri * expert);
  });
  return models;
}

/// Runs visits after a first one whose right camera had rotated sideways unnoticed; the later one is
/// calibrated anew.
void runTurned(const ReturnBench& bench, const EvaluationHead& head, std::uint64_t seed, int frames,
               double sideways_deg, std::vector<ReturnRun>& runs) {
  const std::string words =
      formatted("right camera turned sideways by %.2f deg before the first visit", sideways_deg);
  orRefused(head.name, "plain face", words, seed, runs, [&] {
    RigidTransform<Mri, Coil> expert;
    const auto change = laterVisits(seed, frames, VisitPictures::plain_with_marker).front();
    for (const auto& model : plainModels(bench, head, seed, frames, {false, sideways_deg}, expert, runs)) {
      runs.push_back(visitAgain(bench, model, head, change, expert, {}));
      runs.back().seed = seed, runs.back().change = words;
    }
  });
}

}  // namespace

std::vector<ReturnRun> runReturns(Context& context, const EvaluationHead& head, const EvaluationHead* other,
                                  const ReturnRequest& request) {
  const auto& registrations = context.registrations;
  const ReturnBench bench{context, registrations.aligners.create(registrations.aligners.defaultName()),
                          registrations.face_detector(),
                          registrations.coil_trackers.create(registrations.coil_trackers.defaultName())};
  std::vector<ReturnRun> runs;
  const auto visitAll = [&](const std::vector<ReturnModel>& models, const RigidTransform<Mri, Coil>& expert,
                            std::uint64_t seed) {
    const auto add = [&](ReturnRun run, bool must_be_refused, const char* what) {
      run.seed = seed, run.must_be_refused = must_be_refused;
      if (what) run.change = what;
      runs.push_back(std::move(run));
    };
    for (const auto& model : models) {
      const auto changes = laterVisits(seed, request.frames, model.pictures);
      for (const auto& change : changes) {
        context.monitor.report("returns: " + head.name + ", " + model.name, 0.0);
        add(visitAgain(bench, model, head, change, expert, {}), false, nullptr);
      }
      if (model.pictures == VisitPictures::plain_with_marker)
        for (const double deg : kSideways_deg)
          add(visitAgain(bench, model, head, changes.front(), expert, {false, deg}), false,
              formatted("right camera turned sideways by %.2f deg since", deg).c_str());
      add(visitAgain(bench, model, head, changes.front(), expert, {true}), true,
          "a camera turned by 0.3 deg");
      if (other) add(visitAgain(bench, model, *other, changes.front(), expert, {}), true, "another person");
    }
  };
  for (const std::uint64_t seed : request.seeds) {
    RigidTransform<Mri, Coil> expert;
    if (request.has_dots) {
      const auto models = dottedModels(bench, head, seed, request.frames, expert);
      visitAll(models, expert, seed);
    }
    if (!request.has_plain) continue;
    orRefused(head.name, "plain face", kFirstVisit, seed, runs, [&] {
      const auto models = plainModels(bench, head, seed, request.frames, {}, expert, runs);
      visitAll(models, expert, seed);
    });
    for (const double deg : kSideways_deg) runTurned(bench, head, seed, request.frames, deg, runs);
  }
  return runs;
}

}  // namespace facenav::app
