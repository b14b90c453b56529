#include "facenav/workflow/treat_recording.h"

#include <algorithm>
#include <thread>

#include "facenav/capture/swinging_source.h"
#include "facenav/casefile/sign_off.h"
#include "facenav/core/error.h"
#include "facenav/core/log.h"
#include "facenav/core/robust_statistics.h"
#include "facenav/workflow/align_case.h"
#include "facenav/workflow/coil_library.h"
#include "facenav/workflow/expert_pose.h"
#include "facenav/workflow/session_return.h"
#include "facenav/workflow/sign_off_gate.h"
#include "facenav/workflow/software_version.h"

namespace facenav::workflow {
namespace {

constexpr std::chrono::milliseconds kLook(5);  // at the newest state; frames come 16 ms apart or more

TreatmentRequest treatmentOf(const Registrations& methods, const TreatRecordingRequest& request,
                             TaskMonitor& monitor) {
  const auto store = casefile::CaseStore::open(request.case_folder);
  if (request.override)
    casefile::recordOverride(store, request.override->by, request.override->reason, softwareVersion());
  requireSignOff(store, request.override.has_value());
  auto film = openTreatmentFilm(request.recording);
  std::filesystem::path goes_on;
  if (request.goes_on) {  // the face as it was at the alignment of that session, not as it is now
    goes_on = sessionToGoOnWith(request.case_folder, request.session).folder;
    film.recording.capture.reset();
  }
  if (request.coil_file) {
    film.coil = coil_tracking::readCoil(*request.coil_file);
    film.card = coil_tracking::readCoilCard(*request.coil_file);
  }
  const auto reminder = calibrationReminder(film.card);
  if (reminder) logWarning(*reminder);
  const auto focus = focusCaution(film.card);
  if (focus) logWarning(*focus);
  AlignOrder order{request.aligner};
  order.stored_pair_stands_in = true;
  const auto alignment = std::make_shared<AlignmentOutcome>(
      alignRecording(methods, store, film.recording, order, monitor).outcome);
  TreatmentRequest treatment{store, film.recording, false, film.coil, alignment, reminder};
  treatment.override = request.override;
  treatment.focus_caution = focus;
  treatment.goes_on = goes_on;
  treatment.speed = request.speed;
  return treatment;
}

TreatmentDevices devicesOf(const Registrations& methods, const TreatRecordingRequest& request,
                           const capture::Recording& recording) {
  return {
      [&methods, request](const session::NavigatorSetup& setup) {
        return std::make_unique<session::Navigator>(setup, methods.head_trackers.create(request.head_tracker),
                                                    methods.coil_trackers.create(request.coil_tracker));
      },
      [recording, passes = request.passes] {
        return passes == 1 ? capture::makeSource(recording) : capture::makeSwingingSource(recording, passes);
      }};
}

/// Of a session that goes on, the target that it had.
std::optional<session::ChosenTarget> targetOf(const TreatmentRequest& treatment, std::string name) {
  const auto plan = treatment.store.targets();
  if (name.empty() && !treatment.goes_on.empty()) name = casefile::sessionSoFar(treatment.goes_on).target;
  if (name.empty() && plan.targets.empty()) return std::nullopt;
  return chosenTarget(name.empty() ? plan.targets.front() : plan.find(name), treatment.alignment.get());
}

/// Until the recording's end; the time that each frame took.
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
    try {
      const double all = double(std::max<std::int64_t>(1, frames)) * std::max(1, request.passes);
      monitor.report("treating", std::min(1.0, double(last + 1) / all));
    } catch (const Cancelled&) {  // the session ends as it should, with all that was logged
      break;
    }
    std::this_thread::sleep_for(kLook);
  }
  return processing_ms;
}

}  // namespace

TreatRecordingOutcome treatRecording(const Registrations& methods, const TreatRecordingRequest& request,
                                     TaskMonitor& monitor) {
  std::vector<std::unique_ptr<links::PulseSource>> sources;  // wrong words first, before anything takes time
  for (const auto& words : request.sources) sources.push_back(links::openPulseSource(words));
  const auto wanted = treatmentOf(methods, request, monitor);
  const auto target = targetOf(wanted, request.target);
  if (target)
    if (const auto caution = otherCoilCaution(target->target, wanted.coil.name)) logWarning(*caution);
  Treatment treatment(prepareTreatment(wanted, devicesOf(methods, request, wanted.recording)), target);
  treatment.setIntensity(request.intensity_pct);
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
  treatment.end();
  treatment.keepReport();
  return outcome;
}

}  // namespace facenav::workflow
