#pragma once
// TRACK: a recording -> poses of head and coil, frame by frame; with a case aligned from its capture pair,
// and placed in the MRI. The same code for a real patient and for the demo.

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "facenav/casefile/poses_csv.h"
#include "facenav/session/navigation_state.h"
#include "facenav/workflow/align_case.h"

namespace facenav::workflow {

struct TrackRequest {
  std::filesystem::path recording;
  std::optional<std::filesystem::path> case_folder, coil_file;
  std::string aligner, head_tracker, coil_tracker;  // registered names
  std::string target;                               // of the case; empty: no guidance while tracking
  bool keeps_looks = false;                         // of the face: kept with the case, for the next session
};
struct TrackOutcome {
  std::vector<casefile::PoseRow> poses;       // two rows a frame: head, coil
  std::optional<AlignmentOutcome> alignment;  // when it was made from a capture pair
  int head_tracked = 0, coil_tracked = 0, frames = 0;
  int rig_fault_frames = 0;  // in which every pose was refused, since the cameras have moved
  std::string rig_fault;     // in words; empty: none
  double right_late_ms = 0;  // the right camera exposes after the left one, as known at the end
  double processing_ms_median = 0, processing_ms_p99 = 0;
};
/// `on_frame` (may be empty) sees every state as it is made. Throws Error; also when neither face nor marker
/// was found in any frame.
TrackOutcome trackRecording(const Registrations& methods, const TrackRequest& request, TaskMonitor& monitor,
                            const std::function<void(const session::NavigationState&)>& on_frame = {});

}  // namespace facenav::workflow
