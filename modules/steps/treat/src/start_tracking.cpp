#include "start_tracking.h"

#include <algorithm>

#include "facenav/align/align_case.h"
#include "facenav/align/stored_capture.h"
#include "facenav/core/log.h"
#include "facenav/face/stereo_face.h"
#include "facenav/health/pair_diagnosis.h"
#include "facenav/treat/guide_poses.h"

namespace facenav::steps {
namespace {

// Frames in which a face is found that are tried as the start. In a recording they are spread over it.
constexpr int kMostStarts = 20;

/// Start of the head tracker, and the head's pose at that time.
struct Start {
  head_tracking::HeadReference reference;
  std::optional<RigidTransform<Camera, Mri>> camera_T_mri;
  // Skin that the face was aligned to, if aligned in this run.
  std::shared_ptr<const registration::ScalpField> scalp = nullptr;
};

/// The head tracker of a recording in which no face can be tracked. The coil may be.
class NoHead : public head_tracking::HeadTracker {
 public:
  void start(const cameras::StereoRig&, const head_tracking::HeadReference&, head_tracking::Pace) override {}
  head_tracking::HeadResult track(const cameras::StereoFrame&, const head_tracking::HeadContext&) override {
    return Tracked<head_tracking::HeadPose>(Lost{LostReason::no_face});
  }
};

std::unique_ptr<session::Navigator> makeNavigator(const Registrations& methods, const TrackRequest& request,
                                                  const cameras::StereoRig& rig, Start start,
                                                  const coil_tracking::CoilModel& coil,
                                                  std::unique_ptr<head_tracking::HeadTracker> head) {
  session::NavigatorSetup setup{rig, std::move(start.reference), start.camera_T_mri, coil, {}, start.scalp};
  setup.pace = request.pace;
  if (request.case_folder) setup.key_frames = casefile::readKeyFrames(*request.case_folder);
  auto navigator = std::make_unique<session::Navigator>(setup, std::move(head),
                                                        methods.coil_trackers.create(request.coil_tracker));
  if (request.second_coil_file)
    navigator->addSecondCoil(coil_tracking::readCoil(*request.second_coil_file),
                             methods.coil_trackers.create(request.coil_tracker));
  const auto chosen = [&](const std::string& name) {
    const auto store = casefile::CaseStore::open(request.case_folder.value());
    return session::ChosenTarget{store.targets().find(name), predictedError_mm(store, name).value_or(0.0)};
  };
  if (!request.target.empty()) navigator->setTarget(chosen(request.target));
  if (!request.second_target.empty()) navigator->setSecondTarget(chosen(request.second_target));
  return navigator;
}

/// True if each camera by itself sees a face.
bool doBothSeeAFace(const face::FaceDetector& detector, const cameras::StereoFrame& frame) {
  return !detector.detectAll(frame.left).empty() && !detector.detectAll(frame.right).empty();
}

/// Chooses the start. A first pair of two moments may be followed by a better one, since its pictures differ
/// only while the head moves. If none is, the first is the start.
class StartChoice {
 public:
  explicit StartChoice(const cameras::StereoRig& rig) : rig_(rig) {}
  /// True if a start from this frame may be taken. After a pair of two moments many are tried, and each might
  /// pass by chance: only a face that is seen to fit the calibration counts then.
  bool isPossible(const head_tracking::HeadReference& start) const {
    return !chosen_ ||
           health::diagnosePair(rig_, start.frame, start.face_px).state == health::RigState::holds;
  }
  /// Takes a possible start; true if it is the one.
  bool take(std::unique_ptr<session::Navigator> start) {
    const bool is_first = !chosen_;
    chosen_ = std::move(start);
    const auto fault = chosen_->cameras().fault();
    return !is_first || !fault || !health::isOfTheMoment(fault->state);
  }
  /// Null if there was no start.
  std::unique_ptr<session::Navigator> chosen() { return std::move(chosen_); }

 private:
  const cameras::StereoRig& rig_;
  std::unique_ptr<session::Navigator> chosen_;
};

/// Starts at the first frame in which both cameras see a face that can be tracked. A face may be covered,
/// blurred, cut off or moving in one frame and plain to see in the next. If no frame is of one moment, the
/// first with a face is the start.
StartedTracking startAtFirstFace(const Registrations& methods, const TrackRequest& request,
                                 const capture::Recording& recording,
                                 const std::optional<RigidTransform<Camera, Mri>>& camera_T_mri,
                                 const coil_tracking::CoilModel& coil, TaskMonitor& monitor) {
  const auto detector = methods.face_detector();
  const auto source = capture::makeSource(recording);
  const auto apart = std::max<std::int64_t>(1, recording.frame_count / kMostStarts);
  StartedTracking started;
  started.is_aligned = camera_T_mri.has_value();
  started.why_no_head = "no face was found in any of " + std::to_string(recording.frame_count) +
                        " frames; check that both cameras see the whole face, upright and lit";
  std::shared_ptr<const cameras::StereoFrame> first;
  StartChoice choice(recording.rig);
  bool is_face_found = false;
  std::optional<std::int64_t>
      contradicted;  // a frame in which both cameras see a face, at places that disagree
  for (std::int64_t i = 0, next = 0; auto frame = source->next(); ++i) {
    monitor.report("looking for a face",
                   double(i) / double(std::max<std::int64_t>(1, recording.frame_count)));
    if (!first) first = frame;
    if (i < next) continue;
    const auto face = face::findStereoFace(*detector, recording.rig, *frame);
    if (!face) {
      const bool is_asked = !is_face_found && !contradicted && i % apart == 0;
      if (is_asked && doBothSeeAFace(*detector, *frame)) contradicted = frame->number;
      continue;
    }
    is_face_found = true;
    Start start{{*frame, {}, {}}, camera_T_mri};
    start.reference.face_px = face::outlineOf(face->left);
    if (!choice.isPossible(start.reference)) {
      next = i + apart;
      continue;
    }
    try {
      const bool is_good = choice.take(makeNavigator(methods, request, recording.rig, std::move(start), coil,
                                                     methods.head_trackers.create(request.head_tracker)));
      if (is_good || camera_T_mri) break;
      next = i + apart;
    } catch (const Cancelled&) {
      throw;
    } catch (const Error& error) {
      if (camera_T_mri) throw;  // that pose is of the first frame with a face, not of a later one
      started.why_no_head = error.what();
      next = i + apart;
    }
  }
  if (!first) throw Error("the recording has no frame", recording.folder.string());
  started.navigator = choice.chosen();
  if (started.navigator) {
    started.why_no_head.clear();
    return started;
  }
  if (contradicted && !is_face_found)
    started.why_no_head = "both cameras see a face (frame " + std::to_string(*contradicted) +
                          "), but not where the calibration expects it; check which camera is left, and the "
                          "calibration";
  started.navigator = makeNavigator(methods, request, recording.rig, {{*first, {}, {}}, camera_T_mri}, coil,
                                    std::make_unique<NoHead>());
  return started;
}

/// Starts from another tool's alignment.json without its images. It fits this recording only if the head in
/// the first frame is where it was at that alignment; this cannot be checked here.
RigidTransform<Camera, Mri> storedPose(const casefile::CaseStore& store) {
  const auto alignment = store.alignment();
  if (!alignment)
    throw Error("case is not aligned and the recording has no capture/ pair to align from",
                store.folder().string(), "run 'facenav align' with a capture first");
  logWarning("no capture pair: the head is taken to sit in the first frame as it sat at the alignment");
  return alignment->camera_T_mri;
}

/// True if the case's alignment is from a film. It is not repeated, because the case keeps only one frame of
/// the film.
bool isFromFilm(const casefile::CaseStore& store) {
  const auto alignment = store.alignment();
  return alignment && alignment->from == measured_face::nameOf(measured_face::AlignedFrom::film);
}

}  // namespace

StartedTracking startTracking(const Registrations& methods, const TrackRequest& request,
                              const capture::Recording& recording, const coil_tracking::CoilModel& coil,
                              TaskMonitor& monitor) {
  if (!request.case_folder) return startAtFirstFace(methods, request, recording, std::nullopt, coil, monitor);
  const auto store = casefile::CaseStore::open(*request.case_folder);
  std::optional<capture::CapturePair> capture = recording.capture;
  if (!capture) capture = readStoredCapture(store.folder(), recording.rig);
  if (!capture) return startAtFirstFace(methods, request, recording, storedPose(store), coil, monitor);
  StartedTracking started;
  Start start;
  if (!recording.capture && isFromFilm(store)) {
    start = {{capture->plain, {}, {}}, store.alignment()->camera_T_mri};
    if (const auto face = face::findStereoFace(*methods.face_detector(), recording.rig, capture->plain))
      start.reference.face_px = face::outlineOf(face->left);
  } else {
    capture::Recording pictures = recording;
    pictures.capture = capture;
    AlignOrder order = alignOrderOf(request, coil);
    order.is_patient_confirmed =
        order.is_patient_confirmed || (!recording.capture && store.alignment()->rests_on_confirmation);
    started.alignment = alignRecording(methods, store, pictures, order, monitor).outcome;
    start = {started.alignment->reference, started.alignment->result.camera_T_mri, started.alignment->scalp};
  }
  started.is_aligned = true;
  started.navigator = makeNavigator(methods, request, recording.rig, std::move(start), coil,
                                    methods.head_trackers.create(request.head_tracker));
  return started;
}

StartedTracking startAtLiveFace(const Registrations& methods, const TrackRequest& request,
                                capture::FrameSource& source, const coil_tracking::CoilModel& coil,
                                TaskMonitor& monitor) {
  const auto detector = methods.face_detector();
  StartChoice choice(source.rig());
  int tried = 0;
  while (const auto frame = source.next()) {
    monitor.report("looking for a face", -1);
    if (!frame->absence.empty()) continue;
    const auto face = face::findStereoFace(*detector, source.rig(), *frame);
    if (!face) continue;
    Start start{{*frame, {}, {}}, std::nullopt};
    start.reference.face_px = face::outlineOf(face->left);
    try {
      const bool is_good = choice.isPossible(start.reference) &&
                           choice.take(makeNavigator(methods, request, source.rig(), std::move(start), coil,
                                                     methods.head_trackers.create(request.head_tracker)));
      if (!is_good && ++tried < kMostStarts) continue;
      StartedTracking started;
      started.navigator = choice.chosen();
      return started;
    } catch (const Cancelled&) {
      throw;
    } catch (const Error&) {  // the face cannot be tracked from this frame; the next one may be better
    }
  }
  throw Error("the cameras ended before a face was found");
}

}  // namespace facenav::steps
