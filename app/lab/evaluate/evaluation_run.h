#pragma once
// One run of `facenav evaluate`: a sequence with truth runs in memory through the same code as for a real
// patient (measureFace, aligner, Navigator). The results go into a RunRecord.

#include <functional>
#include <memory>
#include <string>

#include "context.h"
#include "evaluate/evaluation_head.h"
#include "facenav/align/align_from_capture.h"
#include "facenav/capture/frame_source.h"
#include "facenav/capture/recording.h"
#include "facenav/coil_tracking/coil_tracker.h"
#include "facenav/evaluation/cloud_evaluation.h"
#include "facenav/evaluation/run_record.h"
#include "facenav/room/scenario.h"

namespace facenav::app {

struct Methods {
  std::string aligner, head_tracker, coil_tracker;  // registered names
};

/// A sequence with its truth, from any source.
struct EvaluationSequence {
  std::string scenario;  // name; for a recording: from its scenario.json, else its folder's name
  std::shared_ptr<capture::FrameSource> source;
  std::optional<capture::CapturePair> capture;
  std::optional<RigidTransform<Camera, Mri>> capture_truth;         // camera_T_mri at the capture
  std::function<evaluation::FrameTruth(std::int64_t frame)> truth;  // truth for a frame that `source`
                                                                    // returned
  coil_tracking::CoilModel coil;
  double frames_per_s = 60.0;
  std::optional<evaluation::ExactDepth> capture_depth;
  std::optional<Point<Mri>> face_middle;
};

/// Converts the room's coil to the trackers' model.
coil_tracking::CoilModel coilOf(const room::RoomCoil& coil);
/// Makes the sequence of a scenario of the virtual room, rendered on demand.
EvaluationSequence roomSequence(const room::ScenarioOptions& options, const EvaluationHead& head);
/// Reads a recording with truth/ from another program (resources/doc/formats.md). Its scenario.json, if there
/// is one, marks frames in which the pose must be lost and gives the head's pose at the capture. Throws Error
/// if there is no truth or no capture pair.
EvaluationSequence recordedSequence(const std::filesystem::path& recording);

/// The last alignment in a series of runs. Scenarios with the same seat start from the same capture, which is
/// measured only once.
struct AlignedCapture {
  cv::Mat pattern_left;  // identifies the capture
  steps::AlignmentOutcome outcome;
  evaluation::AlignmentRecord record;
  std::optional<evaluation::CloudFigures> cloud;
};

/// Fills cloud, alignment and frames of `run`, whose names must be set. Refusals and failures are recorded
/// there; only Cancelled is thrown. `last` is used if the capture is the same, else replaced. `onFrame`
/// receives the fraction done.
void runSequence(Context& context, EvaluationSequence& sequence, const surface::ScalpSurface& scalp,
                 const guidance::Target& target, const Methods& methods, std::optional<AlignedCapture>& last,
                 evaluation::RunRecord& run, const std::function<void(double)>& onFrame);

}  // namespace facenav::app
