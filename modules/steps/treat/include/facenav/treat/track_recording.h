#pragma once
// TRACK: computes poses of head and coil, frame by frame, from a recording. With a case: aligned from its
// capture pair and placed in the MRI. The same code runs for a real patient and for the demo.

#include <array>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "facenav/align/align_case.h"
#include "facenav/casefile/poses_csv.h"
#include "facenav/session/navigation_state.h"

namespace facenav::steps {

struct TrackRequest {
  std::filesystem::path recording;
  std::optional<std::filesystem::path> case_folder, coil_file;
  std::string aligner, head_tracker, coil_tracker;  // registered names
  std::string target;                               // in the case; empty: no guidance
  bool keeps_key_frames = false;  // stores key frames of the face with the case, for the next session
  head_tracking::Pace pace = head_tracking::Pace::patient;     // a recording may take longer than real time
  std::optional<std::filesystem::path> second_coil_file = {};  // a second coil; nothing: none
  std::string second_target = {};                              // its target in the case; empty: none
  bool is_patient_confirmed = false;                           // as in AlignOrder
};
struct TrackOutcome {
  std::vector<casefile::PoseRow> poses;       // two rows a frame: head, coil
  std::optional<AlignmentOutcome> alignment;  // present if it was made from a capture pair
  /// Rows of the second coil: two a frame as above, and its name. Empty without one.
  std::vector<casefile::PoseRow> second_poses;
  std::string second_coil;
  int head_tracked = 0, coil_tracked = 0, second_tracked = 0, frames = 0;
  int rig_fault_frames = 0;  // frames in which every pose was refused because of a camera fault
  std::optional<health::RigVerdict> rig_fault;            // the last one; empty: none
  std::optional<health::CorrectedMotion> rig_correction;  // for a camera that moved on its mount; empty: none
  // Delay of the right camera's exposure after the left one's, as estimated at the end.
  double right_late_ms = 0;
  // Time from the first row to the last of a picture of the left and the right camera (rolling shutter), from
  // the rig or as measured on the moving coil; 0: none, or unknown.
  std::array<double, 2> readout_ms{0, 0};
  double processing_ms_median = 0, processing_ms_p99 = 0;
};
/// Returns how `trackRecording` aligns the case. An unsure alignment will do: nobody is treated from a
/// recording.
AlignOrder alignOrderOf(const TrackRequest& request, const coil_tracking::CoilModel& coil);

/// Tracks the recording. `on_frame` (may be empty) is called with every state. Throws Error, also when
/// neither face nor marker was found in any frame.
TrackOutcome trackRecording(const Registrations& methods, const TrackRequest& request, TaskMonitor& monitor,
                            const std::function<void(const session::NavigationState&)>& on_frame = {});

}  // namespace facenav::steps
