#pragma once
// The steps of the data flow as the verbs and the demo run them: ALIGN, TRACK, GUIDE (PREPARE:
// prepare_case.h). Composition of module calls with the registered implementations; the same code for a real
// patient and for the demo.

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "context.h"
#include "facenav/capture/recording.h"
#include "facenav/casefile/case_store.h"
#include "facenav/casefile/poses_csv.h"
#include "facenav/guidance/guidance_csv.h"
#include "facenav/session/align_from_capture.h"
#include "facenav/session/navigation_state.h"

namespace facenav::app {

/// Aligns and writes alignment.json and the capture pair it rests on into the case. Throws Error ("not
/// aligned: ..").
session::AlignmentOutcome alignCase(Context& context, const casefile::CaseStore& store,
                                    const stereo::StereoRig& rig, const capture::CapturePair& capture,
                                    const std::string& aligner);

/// Writes an alignment and what it rests on into the case: alignment.json, alignment_capture/ (photographs),
/// skin_fit.vtp and skin_fit.png. All or nothing, for the user alone from the first byte. Throws Error; the
/// alignment of before is whole then.
void storeAlignment(const casefile::CaseStore& store, const stereo::StereoRig& rig,
                    const capture::CapturePair& capture, const session::AlignmentOutcome& outcome);

struct TrackRequest {
  std::filesystem::path recording;
  std::optional<std::filesystem::path> case_folder, coil_file;
  std::string aligner, head_tracker, coil_tracker;  // registered names
  std::string target;                               // of the case; empty: no guidance while tracking
  bool keeps_looks = false;                         // of the face: kept with the case, for the next session
};
struct TrackOutcome {
  std::vector<casefile::PoseRow> poses;                // two rows a frame: head, coil
  std::optional<session::AlignmentOutcome> alignment;  // when it was made from a capture pair
  int head_tracked = 0, coil_tracked = 0, frames = 0;
  int rig_fault_frames = 0;  // in which every pose was refused, since the cameras have moved
  std::string rig_fault;     // in words; empty: none
  double right_late_ms = 0;  // the right camera exposes after the left one, as known at the end
  double processing_ms_median = 0, processing_ms_p99 = 0;
};
/// `on_frame` (may be empty) sees every state as it is made. Throws Error; also when neither face nor marker
/// was found in any frame.
TrackOutcome trackRecording(Context& context, const TrackRequest& request,
                            const std::function<void(const session::NavigationState&)>& on_frame = {});

/// guidance.csv's rows from poses and the case's plan.
std::vector<guidance::GuidanceRow> guidePoses(const casefile::CaseStore& store,
                                              const std::vector<casefile::PoseRow>& poses,
                                              const std::string& target_name);

}  // namespace facenav::app
