#include "facenav/treat/treat_recording.h"

#include <algorithm>
#include <thread>

#include "facenav/align/align_case.h"
#include "facenav/capture/swinging_source.h"
#include "facenav/casefile/sign_off.h"
#include "facenav/coil_library/coil_library.h"
#include "facenav/core/error.h"
#include "facenav/core/log.h"
#include "facenav/core/number_text.h"
#include "facenav/core/robust_statistics.h"
#include "facenav/core/software_version.h"
#include "facenav/efield/coil_file.h"
#include "facenav/geometry/rotation.h"
#include "facenav/plan/expert_pose.h"
#include "facenav/prepare/sign_off_gate.h"
#include "facenav/treat/served_tracker.h"
#include "facenav/treat/session_return.h"
#include "facenav/treat/tracker_alignment.h"

namespace facenav::steps {
namespace {

constexpr std::chrono::milliseconds kLook(5);  // between looks; frames come 16 ms apart or more

/// Opens the recording; with live cameras, only their rig. Without cameras there is none of either.
TreatmentFilm filmOf(const TreatRecordingRequest& request) {
  if (!request.isLive()) return openTreatmentFilm(request.recording);
  TreatmentFilm film{{}, coil_tracking::defaultCoil(), {}};
  film.recording.rig = request.live ? request.live->rig : makeFramesWithoutPictures()->rig();
  film.card.name = film.coil.name;
  return film;
}

/// Makes the alignment order. For live cameras, the pictures of the case's alignment are used again.
AlignOrder orderOf(const casefile::CaseStore& store, const TreatRecordingRequest& request) {
  AlignOrder order{request.aligner};
  order.stored_pair_stands_in = true;
  order.is_patient_confirmed = request.is_patient_confirmed;
  if (request.coil_file) order.coil = coil_tracking::readCoil(*request.coil_file);
  if (!request.live) return order;
  const auto alignment = store.alignment();
  if (!alignment)
    throw Error("the case is not aligned", store.folder().string(),
                "take its pictures first: facenav align CASE --live RIG");
  if (alignment->from) order.from = measured_face::alignedFrom(*alignment->from);
  if (order.from == measured_face::AlignedFrom::film)
    throw Error("the case was aligned from a film, which live cameras do not go on from",
                store.folder().string(), "align it with a pair: facenav align CASE --live RIG");
  return order;
}

/// Aligns from the pictures; without cameras, from the file.
std::shared_ptr<const AlignmentOutcome> alignmentOf(const Registrations& methods,
                                                    const casefile::CaseStore& store,
                                                    const capture::Recording& recording,
                                                    const TreatRecordingRequest& request,
                                                    TaskMonitor& monitor) {
  if (!request.other_tracker)
    return std::make_shared<AlignmentOutcome>(
        alignRecording(methods, store, recording, orderOf(store, request), monitor).outcome);
  auto alignment = std::make_shared<AlignmentOutcome>(
      outcomeOf(readTrackerAlignment(request.other_tracker->alignment), store));
  for (const auto& caution : alignment->result.cautions) logWarning(caution);
  return alignment;
}

std::optional<SecondCoilChoice> secondOf(const TreatRecordingRequest& request,
                                         const casefile::CaseStore& store,
                                         const AlignmentOutcome* alignment) {
  if (!request.second_coil_file) return std::nullopt;
  SecondCoilChoice second{coil_tracking::readCoil(*request.second_coil_file), {}};
  if (!request.second_target.empty())
    second.target = chosenTarget(store.targets().find(request.second_target), alignment);
  return second;
}

TreatmentRequest treatmentOf(const Registrations& methods, const TreatRecordingRequest& request,
                             TaskMonitor& monitor) {
  const auto store = casefile::CaseStore::open(request.case_folder);
  if (request.override)
    casefile::recordOverride(store, request.override->by, request.override->reason, softwareVersion());
  requireSignOff(store, request.override.has_value());
  efield::fieldCoil(request.field_coil);  // refuses a missing file before anything starts
  auto film = filmOf(request);
  std::filesystem::path goes_on;
  if (request.goes_on) {  // uses that session's alignment, not the current face
    goes_on = sessionToGoOnWith(request.case_folder, request.session).folder;
    film.recording.capture.reset();
  }
  if (request.coil_file) {
    film.coil = coil_tracking::readCoil(*request.coil_file);
    film.card = coil_tracking::readCoilCard(*request.coil_file);
  }
  const auto reminder = coil_library::calibrationReminder(film.card);
  if (reminder) logWarning(*reminder);
  const auto focus = coil_library::focusCaution(film.card);
  if (focus) logWarning(*focus);
  const auto alignment = alignmentOf(methods, store, film.recording, request, monitor);
  TreatmentRequest treatment{store, film.recording, request.live.has_value(), film.coil, alignment, reminder};
  treatment.has_cameras = !request.other_tracker;
  treatment.is_coil_served = request.other_tracker || request.makeCoilTracker;
  treatment.second = secondOf(request, store, alignment.get());
  treatment.coil_of_source = request.coil_of_source;
  treatment.is_checked_first = request.live.has_value();
  if (request.live) treatment.keepLearnt = request.live->keepLearnt;
  treatment.override = request.override;
  treatment.focus_caution = focus;
  treatment.goes_on = goes_on;
  treatment.field_coil = request.field_coil;
  treatment.speed = request.isLive() ? 1.0 : request.speed;
  return treatment;
}

TreatmentDevices devicesOf(const Registrations& methods, const TreatRecordingRequest& request,
                           const capture::Recording& recording) {
  if (request.other_tracker) return devicesOf(*request.other_tracker);
  return {
      [&methods, request](const session::NavigatorSetup& setup) {
        auto coil = request.makeCoilTracker ? request.makeCoilTracker()
                                            : methods.coil_trackers.create(request.coil_tracker);
        auto navigator = std::make_unique<session::Navigator>(
            setup, methods.head_trackers.create(request.head_tracker), std::move(coil));
        if (setup.second_coil)
          navigator->addSecondCoil(*setup.second_coil, methods.coil_trackers.create(request.coil_tracker));
        return navigator;
      },
      [recording, passes = request.passes, live = request.live] {
        if (live) return live->open();
        return passes == 1 ? capture::makeSource(recording) : capture::makeSwingingSource(recording, passes);
      }};
}

/// Returns the target; a continued session keeps its own.
std::optional<session::ChosenTarget> targetOf(const TreatmentRequest& treatment, std::string name) {
  const auto plan = treatment.store.targets();
  if (name.empty() && !treatment.goes_on.empty()) name = casefile::sessionSoFar(treatment.goes_on).target;
  if (name.empty() && !plan.damaged.empty())  // the first target that can be read may not be the wanted one
    throw Error("the plan is damaged (" + plan.damaged.front() + ")", {}, "name the target that you want");
  if (name.empty() && plan.targets.empty()) return std::nullopt;
  return chosenTarget(name.empty() ? plan.targets.front() : plan.find(name), treatment.alignment.get());
}

/// Share of the whole session that is done; less than 0: it has no end.
double doneOf(const Treatment& treatment, const TreatRecordingRequest& request, std::int64_t frames,
              std::int64_t last) {
  if (request.isLive() && request.seconds() <= 0) return -1;
  if (request.isLive()) return treatment.session().elapsed_s() / request.seconds();
  return double(last + 1) / (double(std::max<std::int64_t>(1, frames)) * std::max(1, request.passes));
}

/// Follows the session until the end of the recording or of the live time. Returns the time of each frame.
std::vector<double> follow(Treatment& treatment, const TreatRecordingRequest& request, std::int64_t frames,
                           TaskMonitor& monitor) {
  std::vector<double> processing_ms;
  std::int64_t last = -1;
  while (!treatment.session().hasEnded()) {
    const auto state = treatment.session().latest();
    if (state->frame > last) {
      last = state->frame;
      processing_ms.push_back(state->processing_ms);
    }
    if (request.look && !request.look(treatment)) break;
    const double done = doneOf(treatment, request, frames, last);
    if (request.isLive() && done >= 1) break;
    try {
      monitor.report(inWords(treatment, *state), std::min(1.0, done));
    } catch (const Cancelled&) {  // the session ends normally, with its whole log
      break;
    }
    std::this_thread::sleep_for(kLook);
  }
  return processing_ms;
}

/// "B: on target, 1.2 mm, 3 deg off", "B: lost".
std::string secondInWords(const session::SecondCoil& second) {
  const auto& guided = second.guidance;
  if (!second.camera_T_coil) return second.name + ": lost";
  if (!guided.values) return second.name + ": tracked";
  return second.name + formatted(": %s, %.1f mm, %.0f deg off",
                                 guided.state == guidance::State::on_target ? "on target" : "adjust",
                                 guided.values->distance_mm, guided.values->tilt_rad * kDegPerRad);
}

}  // namespace

TreatmentDevices devicesOf(const OtherTracker& tracker) {
  return {[tracker](const session::NavigatorSetup& setup) {
            auto served = makeServedTrackers(tracker.words, tracker.head, tracker.second_coil);
            auto navigator =
                std::make_unique<session::Navigator>(setup, std::move(served.head), std::move(served.coil));
            if (setup.second_coil)
              navigator->addSecondCoil(*setup.second_coil, std::move(served.second_coil));
            return navigator;
          },
          makeFramesWithoutPictures};
}

std::string inWords(const Treatment& treatment, const session::NavigationState& state) {
  const auto& guided = state.guidance;
  std::string words = session::lossInWords(state);
  if (words.empty() && guided.values)
    words = formatted("%s, %.1f mm, %.0f deg off",
                      guided.state == guidance::State::on_target ? "on target" : "adjust",
                      guided.values->distance_mm, guided.values->tilt_rad * kDegPerRad);
  if (words.empty()) words = "head and coil tracked";
  if (state.second) words += "; " + secondInWords(*state.second);
  const auto counts = treatment.log().counts();
  return words + formatted("; %d pulses", counts.on_target + counts.outside + counts.lost);
}

TreatRecordingOutcome treatRecording(const Registrations& methods, const TreatRecordingRequest& request,
                                     TaskMonitor& monitor) {
  std::vector<std::unique_ptr<links::PulseSource>> sources;  // first: wrong words fail at once
  for (const auto& words : request.sources) sources.push_back(links::openPulseSource(words));
  const auto wanted = treatmentOf(methods, request, monitor);
  const auto target = targetOf(wanted, request.target);
  if (target)
    if (const auto caution = otherCoilCaution(target->target, wanted.coil.name)) logWarning(*caution);
  Treatment treatment(prepareTreatment(wanted, devicesOf(methods, request, wanted.recording)), target);
  treatment.setIntensity(request.intensity_pct);
  if (request.outputs) {
    request.outputs->setCase(request.case_folder);
    treatment.sendTo(request.outputs);
  }
  for (auto& source : sources) treatment.listen(std::move(source));
  TreatRecordingOutcome outcome;
  const auto processing_ms = follow(treatment, request, wanted.recording.frame_count, monitor);
  while (treatment.log().pulsesWaiting() > 0 && treatment.log().failure().empty())
    std::this_thread::sleep_for(kLook);
  if (request.look) request.look(treatment);  // the last pulses
  outcome.session = treatment.log().folder();
  outcome.pulses = treatment.log().counts();
  outcome.frames = int(processing_ms.size());
  if (!processing_ms.empty()) {
    outcome.processing_ms_median = median(processing_ms);
    outcome.processing_ms_p99 = valueAtRank(processing_ms, std::size_t(0.99 * double(processing_ms.size())));
  }
  outcome.failure = treatment.session().latest()->failure;
  treatment.end();
  treatment.keepReport();
  return outcome;
}

}  // namespace facenav::steps
