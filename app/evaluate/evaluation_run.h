#pragma once
// One run of `facenav evaluate`: a sequence with its truth goes through the code a real patient gets
// (measureFace, aligner, Navigator) in memory, and everything is noted in a RunRecord.

#include <functional>
#include <memory>
#include <string>

#include "context.h"
#include "evaluate/evaluation_head.h"
#include "facenav/capture/frame_source.h"
#include "facenav/capture/recording.h"
#include "facenav/coil_tracking/coil_tracker.h"
#include "facenav/evaluation/cloud_evaluation.h"
#include "facenav/evaluation/run_record.h"
#include "facenav/room/scenario.h"
#include "facenav/workflow/align_from_capture.h"

namespace facenav::app {

struct Methods {
  std::string aligner, head_tracker, coil_tracker;  // registered names
};

/// A sequence with its truth, wherever it came from.
struct EvaluationSequence {
  std::string scenario;  // by name; of a recording: what its scenario.json says, else its folder's name
  std::shared_ptr<capture::FrameSource> source;
  std::optional<capture::CapturePair> capture;
  std::optional<RigidTransform<Camera, Mri>> capture_truth;         // camera_T_mri at the capture
  std::function<evaluation::FrameTruth(std::int64_t frame)> truth;  // of a frame that source gave
  coil_tracking::CoilModel coil;
  double frames_per_s = 60.0;
  std::optional<evaluation::ExactDepth> capture_depth;
  std::optional<Point<Mri>> face_middle;
};

/// A scenario of the virtual room, rendered as it is asked for.
EvaluationSequence roomSequence(const room::ScenarioOptions& options, const EvaluationHead& head);
/// A recording with truth/ that came from elsewhere (FORMATS.md); scenario.json, where there is one, says
/// which frames no tracker can know and how the head sat at the capture. Throws Error where it holds no truth
/// or no capture pair.
EvaluationSequence recordedSequence(const std::filesystem::path& recording);

/// The last alignment of a row of runs: scenarios with the same seat start from the same capture, which is
/// measured once.
struct AlignedCapture {
  cv::Mat pattern_left;  // which capture
  workflow::AlignmentOutcome outcome;
  evaluation::AlignmentRecord record;
  std::optional<evaluation::CloudFigures> cloud;
};

/// Fills cloud, alignment and frames of `run`, whose names are set. A refusal or a failure is noted there;
/// only Cancelled passes through. `last` is taken over where the capture is the same, else replaced.
/// `onFrame` hears the fraction done.
void runSequence(Context& context, EvaluationSequence& sequence, const surface::ScalpSurface& scalp,
                 const guidance::Target& target, const Methods& methods, std::optional<AlignedCapture>& last,
                 evaluation::RunRecord& run, const std::function<void(double)>& onFrame);

}  // namespace facenav::app
