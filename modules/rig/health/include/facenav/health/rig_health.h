#pragma once
// RigHealth: estimates during a session whether the cameras are positioned as calibrated. It uses the
// measurements of navigation (RigObservation): matches of the face's skin, the coil's marker, and the right
// camera's pose by the tracked face. Cameras that moved since their calibration are detected at the session's
// start and during it, without a board. Costs some tens of microseconds a frame.
//
// A camera that turned sideways moves every point along its epipolar line, so that the face looks right. The
// marker's size reveals it. The coil's tracker then gives no pose; the head's pose is wrong for the same
// cause.

#include <optional>

#include "facenav/cameras/stereo_frame.h"
#include "facenav/health/camera_drift.h"
#include "facenav/health/rig_monitor.h"
#include "facenav/health/rig_state.h"

namespace facenav::health {

class RigHealth {
 public:
  explicit RigHealth(const cameras::StereoRig& rig) : rig_(rig), monitor_(rig), drift_(rig) {}
  /// Starts with the session's reference pair and the face measured in it (Camera, mm, with its pixels in the
  /// left image; may be empty). Checks whether the pair fits the rig (half a second). `face_px`:
  /// outline of the face in the left image; empty: that of the measured one. Only matches on the face count;
  /// without a face those of the whole pair do.
  void start(const cameras::StereoFrame& pair, const PointCloud<Camera>& face,
             const std::vector<Eigen::Vector2f>& left_px, const std::vector<cv::Point>& face_px);
  /// Adds the next frame, which was tracked with right_T_left() as of the frame before.
  void add(const RigObservation& seen);
  /// Reason why no pose can be trusted, as of the last judgement (some frames ago); nullopt if no fault is
  /// known.
  std::optional<RigVerdict> fault() const;
  /// Pose of the right camera for the next frame: as calibrated, or corrected for a motion on the mount.
  RigidTransform<RightCamera, Camera> right_T_left() const { return drift_.right_T_left(); }
  /// Standard error of the direction of right_T_left(), beyond the calibration's.
  double rightTurnSigma_rad() const { return drift_.turnSigma_rad(); }
  /// The motion that is corrected; nullopt if none is, or nothing tells yet that it is one.
  std::optional<CorrectedMotion> correction() const;

 private:
  void followDrift();
  bool isCauseTold() const;

  cameras::StereoRig rig_;
  RigMonitor monitor_;
  RigEstimate estimate_;
  CameraDrift drift_;
  std::optional<RigVerdict> reference_fault_;  // a session that starts with such images stays wrong
  bool has_fitted_ = false;                    // the reference pair's face fitted its calibration
  bool has_seen_square_ = false;               // of a coil at rest
  std::size_t frames_ = 0;
  /// Frames in a row in which a coil at rest contradicts, or fits, the size and the rows of its print.
  int contradicted_ = 0, agreed_ = 0;
  bool coil_contradicts_ = false;
};

/// Frames at a session's start in which the cameras are judged more often, with more matches.
constexpr std::size_t kFirstFrames = 30;

}  // namespace facenav::health
