#include "facenav/treat/track_recording.h"

#include <algorithm>
#include <map>

#include "facenav/core/log.h"
#include "facenav/session/navigator.h"
#include "start_tracking.h"

namespace facenav::steps {
namespace fs = std::filesystem;
namespace {

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

/// Adds the second coil's rows: the head's row of this frame again, and its own.
void addSecondRows(const session::NavigationState& state, TrackOutcome& outcome) {
  if (!state.second) return;
  outcome.second_coil = state.second->name;
  outcome.second_tracked += state.second->coil.isTracked();
  outcome.second_poses.push_back(outcome.poses[outcome.poses.size() - 2]);
  outcome.second_poses.push_back(casefile::poseRow(state.frame, state.captured.s, casefile::PoseObject::coil,
                                                   state.second->camera_T_coil));
}

Error nothingFound(const StartedTracking& started, std::int64_t frames, const fs::path& recording) {
  return Error("neither the face nor a marker was found in any of " + std::to_string(frames) +
                   " frames: " + started.why_no_head,
               recording.string());
}

/// Says why a face that was found is tracked in no frame: "a face was found, but .. (57 x not_found)".
std::string refusedThroughout(const std::vector<casefile::PoseRow>& poses) {
  std::map<std::string, int> frames;
  for (const auto& row : poses) {
    if (row.object != casefile::PoseObject::head || row.pose) continue;
    ++frames[row.detail.empty() ? toString(row.reason.value_or(LostReason::no_face)) : row.detail];
  }
  std::string words;
  for (const auto& [word, count] : frames)
    words += (words.empty() ? "" : ", ") + std::to_string(count) + " x " + word;
  return "a face was found, but no frame gave a pose that can be trusted (" + words +
         "); check light, focus and the calibration, or record the face larger and more from the front";
}

double quantile(std::vector<double> values, double fraction) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  return values[std::min(values.size() - 1, std::size_t(fraction * double(values.size())))];
}

}  // namespace

AlignOrder alignOrderOf(const TrackRequest& request, const coil_tracking::CoilModel& coil) {
  AlignOrder order{request.aligner, request.head_tracker};
  order.coil = coil;
  order.may_be_unsure = true;
  order.is_patient_confirmed = request.is_patient_confirmed;
  return order;
}

TrackOutcome trackRecording(const Registrations& methods, const TrackRequest& request, TaskMonitor& monitor,
                            const std::function<void(const session::NavigationState&)>& on_frame) {
  const auto recording = capture::openRecording(request.recording);
  const auto coil =
      request.coil_file ? coil_tracking::readCoil(*request.coil_file) : coil_tracking::defaultCoil();
  TrackOutcome outcome;
  StartedTracking started = startTracking(methods, request, recording, coil, monitor);
  outcome.alignment = std::move(started.alignment);
  const bool is_aligned = started.is_aligned;
  session::Navigator& navigator = *started.navigator;
  const auto source = capture::makeSource(recording);
  std::vector<double> processing_ms;
  while (auto frame = source->next()) {
    monitor.report("tracking", double(outcome.frames) / double(recording.frame_count));
    const auto state = navigator.process(frame);
    addRows(state, is_aligned, request.coil_file.has_value(), outcome.poses);
    addSecondRows(state, outcome);
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
  const bool has_face = started.why_no_head.empty();
  if (!has_face && outcome.coil_tracked + outcome.second_tracked == 0 && outcome.rig_fault_frames == 0)
    throw nothingFound(started, outcome.frames, request.recording);
  if (has_face && outcome.head_tracked == 0 && outcome.rig_fault_frames == 0)
    started.why_no_head = refusedThroughout(outcome.poses);
  if (!started.why_no_head.empty()) logWarning("the head is not tracked: " + started.why_no_head);
  if (outcome.rig_fault_frames > 0)
    logWarning(outcome.rig_fault->words() + " (in " + std::to_string(outcome.rig_fault_frames) + " of " +
               std::to_string(outcome.frames) + " frames every pose is refused)");
  if (outcome.rig_correction) logWarning(inWords(*outcome.rig_correction));
  outcome.processing_ms_median = quantile(processing_ms, 0.5);
  outcome.processing_ms_p99 = quantile(processing_ms, 0.99);
  return outcome;
}

}  // namespace facenav::steps
