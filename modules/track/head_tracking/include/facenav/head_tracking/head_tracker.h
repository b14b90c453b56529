#pragma once
// HeadTracker: the live head from stereo frames (paper, section 4). camera_T_head is the motion since the
// reference frame (Head = Camera there), so camera_T_mri = camera_T_head * head_T_mri with head_T_mri fixed
// at alignment. "model": hundreds of skin patches fitted jointly in both images (default). Hot path: loss is
// a value (Lost), never an exception.

#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "facenav/cameras/exposure_offset.h"
#include "facenav/cameras/stereo_frame.h"
#include "facenav/cameras/stereo_rig.h"
#include "facenav/core/frame_work.h"
#include "facenav/core/tracked.h"
#include "facenav/face/face_landmarks.h"
#include "facenav/geometry/rotation.h"
#include "facenav/head_tracking/face_key_frame.h"
#include "facenav/head_tracking/loss_detail.h"
#include "facenav/health/observation.h"

namespace facenav::head_tracking {

/// A feature as drawn in the camera views.
struct FaceFeature {
  Eigen::Vector2d left_px, right_px;
  double weight = 0.0;  // 0..1, NCC or robust weight
};

struct HeadPose {
  RigidTransform<Camera, Head> camera_T_head;
  // Covariance of xi = (w rad, v mm), the error that moves the true face points p to c + exp(w)(p - c) + v, c
  // = face_centre.
  Matrix6d covariance = Matrix6d::Zero();
  Point<Camera> face_centre;  // centre of the tracked points, at this pose
  std::vector<FaceFeature> features;
  std::optional<cv::Rect> face_left;  // the face's box in the left image
  // Upper bound of the face's motion between the left camera's exposure and the right one's. The pose is
  // corrected for the known part of it. Other comparisons of the two images are valid only up to some tenths.
  double between_exposures_mm = 0.0;
  std::optional<health::RightPoseObservation> right_camera;  // empty if too little of the face is visible
};

/// Input from which the tracker learns the face: a frame without dots and, if the face was measured densely
/// at the same head position, its points (Camera, mm) with their pixels in the left image as recorded.
struct HeadReference {
  cameras::StereoFrame frame;
  PointCloud<Camera> surface;  // if empty, depth is measured in the frame itself
  std::vector<Eigen::Vector2f> surface_left_px;
  std::vector<FaceKeyFrame> key_frames = {};  // the patient's face in earlier sessions
  std::vector<cv::Point> face_px = {};        // outline of the face in the left image; empty: unknown
};

/// When and where work runs that takes longer than a frame (recovery of a lost face).
enum class Pace {
  as_live,  // in its frame, used 0.1 s later: a recording then gives the same result as live
  live,     // in a thread of its own
  patient,  // in its frame, and used there; for recordings, if time does not matter
};

/// Input from the session for each frame.
struct HeadContext {
  FrameWork reserved;  // work of this frame that is reserved for the other tracker
  /// The drift watchdog has raised an alarm: discard everything learnt since start() and in earlier sessions,
  /// and track from the reference.
  bool is_learnt_in_doubt = false;
  /// Pose of the right camera in this frame; empty: as in the frame before, at first as at start().
  std::optional<RigidTransform<RightCamera, Camera>> right_T_left = {};
};

/// The pose or Lost, with further results of the frame.
struct HeadResult : Tracked<HeadPose> {
  using Tracked<HeadPose>::Tracked;
  HeadResult(Tracked<HeadPose> pose) : Tracked<HeadPose>(std::move(pose)) {}
  LossDetail loss_detail = LossDetail::unknown;  // detail of a loss
  cameras::ExposureOffset exposure_offset;       // estimated from the moving head so far
  FrameWork work;                                // done in this frame; 0 if not counted
  double beside_ms = 0.0;  // part of this call's time that a live session spends in parallel with the frames
};

class HeadTracker {
 public:
  virtual ~HeadTracker() = default;
  /// Starts again and discards everything from an earlier start. Throws Error("no face ...") if the reference
  /// frame shows no face.
  virtual void start(const cameras::StereoRig& rig, const HeadReference& reference, Pace pace) = 0;
  void start(const cameras::StereoRig& rig, const HeadReference& reference) {
    start(rig, reference, Pace::as_live);
  }
  /// Accepts any frame after start(); frames may have been dropped in between, and the first may be far from
  /// the reference. Returns Lost{camera} for an unusable frame (no image, another size). Never throws.
  virtual HeadResult track(const cameras::StereoFrame& frame, const HeadContext& context) = 0;
  HeadResult track(const cameras::StereoFrame& frame) { return track(frame, HeadContext()); }
  /// Key frames learnt since start() that are reliable enough to be saved with the case.
  virtual std::vector<FaceKeyFrame> learntKeyFrames() const { return {}; }
};

/// Makes "model". Creates its own face detector, or uses the given one (the landmark model takes 100 MB).
std::unique_ptr<HeadTracker> makeModelHeadTracker(
    std::shared_ptr<const face::FaceDetector> detector = nullptr);  // default: its own

/// Returns the face's motion in a film, for its dense measurement (measured_face::measureFilm). The first
/// frame that the function is called with starts the tracker. `tracker` must outlive it.
std::function<std::optional<RigidTransform<Camera, Head>>(const cameras::StereoFrame& frame)>
motionSinceFirst(HeadTracker& tracker, const cameras::StereoRig& rig);

}  // namespace facenav::head_tracking
