#include "facenav/treat/track_recording.h"

#include <algorithm>

#include "facenav/align/stored_capture.h"
#include "facenav/core/log.h"
#include "facenav/health/rig_error.h"
#include "facenav/session/navigator.h"
#include "facenav/treat/guide_poses.h"

namespace facenav::steps {
namespace fs = std::filesystem;
namespace {

/// Start of the head tracker, and the head's pose at that time.
struct Start {
  head_tracking::HeadReference reference;
  std::optional<RigidTransform<Camera, Mri>> camera_T_mri;
  // Skin that the face was aligned to, if aligned in this run.
  std::shared_ptr<const registration::ScalpField> scalp = nullptr;
};

/// Returns the first frame in which both cameras see a face. Tracking without an alignment starts there.
std::shared_ptr<const cameras::StereoFrame> firstFrameWithFace(const Registrations& methods,
                                                               const capture::Recording& recording,
                                                               TaskMonitor& monitor) {
  const auto detector = methods.face_detector();
  const auto source = capture::makeSource(recording);
  std::shared_ptr<const cameras::StereoFrame> first;
  for (std::int64_t i = 0; auto frame = source->next(); ++i) {
    if (!first) first = frame;
    monitor.report("looking for a face",
                   double(i) / double(std::max<std::int64_t>(1, recording.frame_count)));
    if (detector->detect(frame->left) && detector->detect(frame->right)) return frame;
  }
  if (first) {
    const auto diagnosis = health::diagnosePair(recording.rig, *first);
    if (diagnosis.isFault()) throw health::RigError(diagnosis);
  }
  throw Error("no face was found in any of " + std::to_string(recording.frame_count) + " frames",
              recording.folder.string(), "check that both cameras see the whole face, upright and lit");
}

Start startWithoutCase(const Registrations& methods, const capture::Recording& recording,
                       TaskMonitor& monitor) {
  return {{*firstFrameWithFace(methods, recording, monitor), {}, {}}, std::nullopt};
}

/// Starts from another tool's alignment.json without its images. It fits this recording only if the head in
/// the first frame is where it was at that alignment; this cannot be checked here.
Start startFromStoredPose(const Registrations& methods, const casefile::CaseStore& store,
                          const capture::Recording& recording, TaskMonitor& monitor) {
  const auto alignment = store.alignment();
  if (!alignment)
    throw Error("case is not aligned and the recording has no capture/ pair to align from",
                store.folder().string(), "run 'facenav align' with a capture first");
  logWarning("no capture pair: the head is taken to sit in the first frame as it sat at the alignment");
  Start start = startWithoutCase(methods, recording, monitor);
  start.camera_T_mri = alignment->camera_T_mri;
  return start;
}

/// True if the case's alignment is from a film. It is not repeated, because the case keeps only one frame of
/// the film.
bool isFromFilm(const casefile::CaseStore& store) {
  const auto alignment = store.alignment();
  return alignment && alignment->from == measured_face::nameOf(measured_face::AlignedFrom::film);
}

Start startOf(const Registrations& methods, const TrackRequest& request, const capture::Recording& recording,
              TrackOutcome& outcome, TaskMonitor& monitor) {
  if (!request.case_folder) return startWithoutCase(methods, recording, monitor);
  const auto store = casefile::CaseStore::open(*request.case_folder);
  std::optional<capture::CapturePair> capture = recording.capture;
  if (!capture) {
    capture = readStoredCapture(store.folder(), recording.rig);
    if (capture && isFromFilm(store)) return {{capture->plain, {}, {}}, store.alignment()->camera_T_mri};
  }
  if (!capture) return startFromStoredPose(methods, store, recording, monitor);
  outcome.alignment = alignCase(methods, store, recording.rig, *capture, request.aligner, monitor);
  return {outcome.alignment->reference, outcome.alignment->result.camera_T_mri, outcome.alignment->scalp};
}

session::Navigator makeNavigator(const Registrations& methods, const TrackRequest& request,
                                 const capture::Recording& recording, Start start,
                                 const coil_tracking::CoilModel& coil) {
  session::NavigatorSetup setup{recording.rig, std::move(start.reference), start.camera_T_mri, coil, {},
                                start.scalp};
  setup.pace = head_tracking::Pace::patient;  // a recording may take longer than real time
  if (request.case_folder) setup.key_frames = casefile::readKeyFrames(*request.case_folder);
  session::Navigator navigator(setup, methods.head_trackers.create(request.head_tracker),
                               methods.coil_trackers.create(request.coil_tracker));
  if (!request.target.empty()) {
    const auto store = casefile::CaseStore::open(request.case_folder.value());
    navigator.setTarget(session::ChosenTarget{store.targets().find(request.target),
                                              predictedError_mm(store, request.target).value_or(0.0)});
  }
  return navigator;
}

void addRows(const session::NavigationState& state, bool is_aligned, bool has_coil_file,
             std::vector<casefile::PoseRow>& rows) {
  using casefile::PoseObject;
  const double t_s = state.captured.s;
  if (is_aligned) {
    rows.push_back(casefile::poseRow(state.frame, t_s, PoseObject::head, state.camera_T_mri));
  } else {
    using HeadMotion = Tracked<RigidTransform<Camera, Head>>;
    rows.push_back(casefile::poseRow(state.frame, t_s, PoseObject::head,
                                     state.head ? HeadMotion(state.head->camera_T_head, state.head.quality())
                                                : HeadMotion(Lost{state.head.reason()})));
  }
  rows.back().detail = session::lossWord(state);
  if (has_coil_file) {
    rows.push_back(casefile::poseRow(state.frame, t_s, PoseObject::coil, state.camera_T_coil));
  } else {
    using MarkerPose = Tracked<RigidTransform<Camera, Marker>>;
    rows.push_back(casefile::poseRow(state.frame, t_s, PoseObject::coil,
                                     state.coil
                                         ? MarkerPose(state.coil->camera_T_marker, state.coil.quality())
                                         : MarkerPose(Lost{state.coil.reason()})));
  }
}

double quantile(std::vector<double> values, double fraction) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  return values[std::min(values.size() - 1, std::size_t(fraction * double(values.size())))];
}

}  // namespace

TrackOutcome trackRecording(const Registrations& methods, const TrackRequest& request, TaskMonitor& monitor,
                            const std::function<void(const session::NavigationState&)>& on_frame) {
  const auto recording = capture::openRecording(request.recording);
  const auto coil =
      request.coil_file ? coil_tracking::readCoil(*request.coil_file) : coil_tracking::defaultCoil();
  TrackOutcome outcome;
  Start start = startOf(methods, request, recording, outcome, monitor);
  const bool is_aligned = start.camera_T_mri.has_value();
  auto navigator = makeNavigator(methods, request, recording, std::move(start), coil);
  const auto source = capture::makeSource(recording);
  std::vector<double> processing_ms;
  while (auto frame = source->next()) {
    monitor.report("tracking", double(outcome.frames) / double(recording.frame_count));
    const auto state = navigator.process(frame);
    addRows(state, is_aligned, request.coil_file.has_value(), outcome.poses);
    ++outcome.frames;
    outcome.head_tracked += state.head.isTracked();
    outcome.coil_tracked += state.coil.isTracked();
    processing_ms.push_back(state.processing_ms);
    if (const auto fault = session::rigFault(state)) ++outcome.rig_fault_frames, outcome.rig_fault = fault;
    outcome.rig_correction = state.rig_correction;
    outcome.right_late_ms = 1e3 * state.exposure_offset.right_late_s;
    for (std::size_t side = 0; side < 2; ++side)
      outcome.readout_ms[side] = 1e3 * state.row_times_s[side] * recording.rig.height_px;
    if (on_frame) on_frame(state);
  }
  if (request.case_folder && request.keeps_key_frames)
    casefile::addKeyFrames(*request.case_folder, navigator.learntKeyFrames());
  if (outcome.head_tracked == 0 && outcome.coil_tracked == 0 && outcome.rig_fault_frames > 0)
    throw Error(outcome.rig_fault->words(), request.recording.string());
  if (outcome.head_tracked == 0 && outcome.coil_tracked == 0)
    throw Error(
        "neither the face nor a marker was found in any of " + std::to_string(outcome.frames) + " frames",
        request.recording.string(), "check that both cameras see them, lit and in focus");
  if (outcome.rig_fault_frames > 0)
    logWarning(outcome.rig_fault->words() + " (in " + std::to_string(outcome.rig_fault_frames) + " of " +
               std::to_string(outcome.frames) + " frames every pose is refused)");
  if (outcome.rig_correction) logWarning(inWords(*outcome.rig_correction));
  outcome.processing_ms_median = quantile(processing_ms, 0.5);
  outcome.processing_ms_p99 = quantile(processing_ms, 0.99);
  return outcome;
}

}  // namespace facenav::steps
