#pragma once
// HeadTracker: the live head from stereo frames (paper, section 4). camera_T_head is the motion since the
// reference frame (Head = Camera there), so camera_T_mri = camera_T_head * head_T_mri with head_T_mri fixed
// at alignment. "features7": the paper's seven features, NCC, equations 2-5. "model": hundreds of skin
// patches fitted jointly in both images (default). Hot path: loss is a value (Lost), never an exception.

#include <memory>
#include <optional>
#include <vector>

#include "facenav/cameras/stereo_frame.h"
#include "facenav/cameras/stereo_rig.h"
#include "facenav/core/frame_work.h"
#include "facenav/core/tracked.h"
#include "facenav/face/face_landmarks.h"
#include "facenav/geometry/rotation.h"
#include "facenav/head_tracking/face_look.h"
#include "facenav/head_tracking/loss_detail.h"

namespace facenav::head_tracking {

/// A feature as drawn in the camera views.
struct FaceFeature {
  Eigen::Vector2d left_px, right_px;
  double weight = 0.0;  // 0..1, NCC or robust weight
};

struct HeadPose {
  RigidTransform<Camera, Head> camera_T_head;
  // Of xi = (w rad, v mm), the error that moves the true face points p to c + exp(w)(p - c) + v, c =
  // face_centre.
  Matrix6d covariance = Matrix6d::Zero();
  Point<Camera> face_centre;  // of the tracked points, at this pose
  std::vector<FaceFeature> features;
  std::optional<cv::Rect> face_left;  // where the face was found in the left image
  // How far the face may have moved from the left camera's exposure to the right one's. The pose allows for
  // what is known of it; what else compares both images must not, beyond some tenths.
  double between_exposures_mm = 0.0;
};

/// How much later than the left camera the right one exposes: ordinary cameras run free.
struct ExposureOffset {
  double right_late_s = 0.0;  // 0 while it is not known to differ from 0
  double sigma_s = 0.0;       // 0: not measured
};

/// What the tracker learns the face from: a frame without dots, and, where the face was measured densely at
/// the same head position, its points (Camera, mm) with their pixels in the left image as recorded.
struct HeadReference {
  cameras::StereoFrame frame;
  PointCloud<Camera> surface;  // may be empty: then depth comes from the frame itself
  std::vector<Eigen::Vector2f> surface_left_px;
};

/// What becomes of work that takes longer than a frame (a lost face found anew).
enum class Pace {
  as_live,  // done in its frame, its answer counts 0.1 s later: a recording gives what a live session would
  live,     // in a thread of its own
  patient,  // done in its frame and used there: for recordings that nobody waits for
};

class HeadTracker {
 public:
  virtual ~HeadTracker() = default;
  /// Before start().
  virtual void setPace(Pace /*pace*/) {}
  /// Throws Error("no face ...") when no face is found in the reference frame.
  virtual void start(const cameras::StereoRig& rig, const HeadReference& reference) = 0;
  /// Any frame after start(); frames may have been dropped in between, and the first may be far from the
  /// reference.
  virtual Tracked<HeadPose> track(const cameras::StereoFrame& frame) = 0;
  /// Of the last frame, where it was lost.
  virtual LossDetail lossDetail() const { return LossDetail::unknown; }
  /// As learnt from the moving head so far.
  virtual ExposureOffset exposureOffset() const { return {}; }
  /// Of the last frame; 0 where the method does not count.
  virtual FrameWork work() const { return {}; }
  /// Of the last frame's time, what a live session does beside the frames (ms).
  virtual double beside_ms() const { return 0.0; }
  /// So much of the frame to come is to be left for another tracker.
  virtual void leave(const FrameWork& /*work*/) {}
  /// What was learnt since start() is in doubt (the drift watchdog's alarm): track from the reference anew.
  virtual void forgetLearnt() {}
  /// After start(), before the first frame: other looks of the patient's face, from earlier sessions.
  virtual void addLooks(const std::vector<FaceLook>& /*looks*/) {}
  /// Looks learnt since start() that are sure enough to be kept.
  virtual std::vector<FaceLook> learntLooks() const { return {}; }
};

/// Each makes its own face detector, or shares the one given (its landmark model takes 100 MB).
std::unique_ptr<HeadTracker> makeFeatureHeadTracker(
    std::shared_ptr<const face::FaceDetector> detector = nullptr);  // "features7"
std::unique_ptr<HeadTracker> makeModelHeadTracker(
    std::shared_ptr<const face::FaceDetector> detector = nullptr);  // "model"

}  // namespace facenav::head_tracking
