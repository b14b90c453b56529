#include "evaluate/evaluation_run.h"

#include "evaluate/timed_trackers.h"
#include "facenav/align/align_from_capture.h"
#include "facenav/core/processor_time.h"
#include "facenav/session/navigator.h"

namespace facenav::app {
namespace {

/// Returns true if the whole square is inside both images and seen from the front.
bool isMarkerInView(const cameras::StereoRig& rig, const Eigen::Isometry3d& camera_T_marker, double size_mm) {
  constexpr double kMargin_px = 3.0;
  const Eigen::Isometry3d right_T_marker = rig.right_T_left.isometry() * camera_T_marker;
  for (const auto& [camera, pose] : {std::pair{&rig.left, camera_T_marker}, {&rig.right, right_T_marker}}) {
    if (pose.linear().col(2).dot(pose.translation().normalized()) < 0.2) return false;
    for (const double x : {-0.5, 0.5})
      for (const double y : {-0.5, 0.5}) {
        const Eigen::Vector3d p = pose * Eigen::Vector3d(x * size_mm, y * size_mm, 0.0);
        if (p.z() <= 0.0) return false;
        const Eigen::Vector2d px = cameras::project(*camera, p);
        if (px.x() < kMargin_px || px.y() < kMargin_px || px.x() > rig.width_px - 1 - kMargin_px ||
            px.y() > rig.height_px - 1 - kMargin_px)
          return false;
      }
  }
  return true;
}

void noteCloud(const EvaluationSequence& sequence, const stereo::FaceCloud& face,
               evaluation::RunRecord& run) {
  if (!sequence.capture_depth || !sequence.capture_truth || !sequence.face_middle) return;
  const auto& rig = sequence.source->rig();
  const cv::Mat visible =
      evaluation::visibleFace(rig, *sequence.capture_depth, *sequence.capture_truth * *sequence.face_middle);
  run.cloud = evaluation::evaluateCloud(rig, face, *sequence.capture_depth, visible);
}

bool isSameCapture(const cv::Mat& a, const cv::Mat& b) {
  return a.size() == b.size() && a.type() == b.type() && cv::norm(a, b, cv::NORM_INF) == 0.0;
}

/// Aligns and records the errors; returns nothing if the alignment was refused.
std::optional<AlignedCapture> align(Context& context, const EvaluationSequence& sequence,
                                    const surface::ScalpSurface& scalp, const guidance::Target& target,
                                    const Methods& methods, evaluation::RunRecord& run) {
  run.alignment.emplace();
  LastCall fit;
  const auto aligner = timed(context.registrations.aligners.create(methods.aligner), fit);
  const double start_ms = processorTime_ms();
  try {
    AlignedCapture aligned;
    aligned.pattern_left = sequence.capture->pattern.left;
    const std::vector<guidance::Target> targets{target};
    const auto detector = context.registrations.face_detector();
    aligned.outcome =
        steps::alignFromCapture(sequence.source->rig(), *sequence.capture, measured_face::AlignedFrom::dots,
                                {scalp, *aligner, *detector, targets}, context.monitor);
    const auto& result = aligned.outcome.result;
    run.alignment->measure_ms = processorTime_ms() - start_ms - fit.ms;
    run.alignment->fit_ms = fit.ms;
    run.alignment->estimated = result.camera_T_mri.isometry();
    run.alignment->truth = sequence.capture_truth->isometry();
    run.alignment->predicted_mm = result.predictedError_mm(target.cortex_point);
    run.alignment->bound95_mm = result.errorBound_mm(target.cortex_point);
    run.alignment->rms_mm = result.rms_mm;
    noteCloud(sequence, aligned.outcome.face, run);
    aligned.record = *run.alignment;
    aligned.cloud = run.cloud;
    return aligned;
  } catch (const Cancelled&) {
    throw;
  } catch (const Error& refusal) {
    run.alignment->refusal = refusal.what();
    return std::nullopt;
  }
}

/// Reuses the last alignment if the capture is the same, else aligns again.
void alignOrTakeOver(Context& context, const EvaluationSequence& sequence, const surface::ScalpSurface& scalp,
                     const guidance::Target& target, const Methods& methods,
                     std::optional<AlignedCapture>& last, evaluation::RunRecord& run) {
  if (!last || !isSameCapture(last->pattern_left, sequence.capture->pattern.left)) {
    last = align(context, sequence, scalp, target, methods, run);
    return;
  }
  run.is_capture_repeated = true;
  run.alignment = last->record;
  run.cloud = last->cloud;
}

evaluation::FrameRecord record(const session::NavigationState& state, evaluation::FrameTruth truth,
                               const EvaluationSequence& sequence) {
  evaluation::FrameRecord frame;
  frame.frame = state.frame;
  frame.t_s = state.captured.s;
  if (state.head) frame.head_motion = state.head->camera_T_head.isometry();
  if (state.coil) frame.marker = state.coil->camera_T_marker.isometry();
  frame.is_marker_in_view = truth.marker && isMarkerInView(sequence.source->rig(), *truth.marker,
                                                           sequence.coil.markers.front().size_mm);
  frame.is_camera_noticed = state.rig_correction || session::rigFault(state);
  frame.truth = std::move(truth);
  return frame;
}

}  // namespace

void runSequence(Context& context, EvaluationSequence& sequence, const surface::ScalpSurface& scalp,
                 const guidance::Target& target, const Methods& methods, std::optional<AlignedCapture>& last,
                 evaluation::RunRecord& run, const std::function<void(double)>& onFrame) {
  run.target_mm = target.cortex_point.mm;
  run.frames_per_s = sequence.frames_per_s;
  run.marker_T_coil = sequence.coil.marker_T_coil().isometry();
  run.true_reference = sequence.capture_truth->isometry();
  try {
    alignOrTakeOver(context, sequence, scalp, target, methods, last, run);
    if (!last) return;
    LastCall head, coil;
    session::NavigatorSetup setup{
        sequence.source->rig(), last->outcome.reference, last->outcome.result.camera_T_mri, sequence.coil, {},
        last->outcome.scalp};
    session::Navigator navigator(
        setup, timed(context.registrations.head_trackers.create(methods.head_tracker), head),
        timed(context.registrations.coil_trackers.create(methods.coil_tracker), coil));
    const double count = double(sequence.source->frameCount().value_or(1));
    while (const auto frame = sequence.source->next()) {
      const auto state = navigator.process(frame);
      run.frames.push_back(record(state, sequence.truth(frame->number), sequence));
      run.frames.back().head_ms = head.ms;
      run.frames.back().coil_ms = coil.ms;
      onFrame(double(run.frames.size()) / count);
    }
  } catch (const Cancelled&) {
    throw;
  } catch (const Error& error) {
    run.failure = error.what();
  }
}

}  // namespace facenav::app
