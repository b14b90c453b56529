#pragma once
// RigCheck: feeds cameras::RigMonitor with what navigation measures anyway: textured points of the face,
// matched again in both directions, and the coil's marker. Cameras that moved since their calibration are
// noticed at the session's start and during it, without a board. Costs some tens of microseconds a frame.
//
// A camera that turned sideways moves every point along its epipolar line, so that the face looks right. The
// marker's size shows it. The coil's tracker then gives no pose; the head's pose is wrong for the same cause.

#include "facenav/cameras/rig_monitor.h"
#include "facenav/coil_tracking/coil_tracker.h"
#include "facenav/head_tracking/head_tracker.h"
#include "facenav/monitoring/camera_drift.h"
#include "facenav/monitoring/pair_fault.h"

namespace facenav::monitoring {

/// Points of a measured surface (Camera, mm, with their left pixels), matched again in this pair. Used to
/// check a capture before it is aligned. At most `most` of them, spread over the surface.
std::vector<cameras::Correspondence> matchSurface(const cameras::StereoRig& rig,
                                                  const cameras::StereoFrame& frame,
                                                  const PointCloud<Camera>& surface,
                                                  const std::vector<Eigen::Vector2f>& left_px,
                                                  std::size_t most = 600);

class RigCheck {
 public:
  explicit RigCheck(const cameras::StereoRig& rig) : rig_(rig), monitor_(rig), drift_(rig) {}
  /// The session's reference pair: checks as a whole whether it fits the rig (half a second).
  void start(const head_tracking::HeadReference& reference);
  void add(const cameras::StereoFrame& frame, const Tracked<head_tracking::HeadPose>& head,
           const coil_tracking::CoilResult& coil);
  /// Why no pose can be trusted, as of the last verdict (some frames ago); empty if no fault is known.
  std::optional<RigFault> fault() const;
  /// How the cameras stand, for the next frame: as calibrated, or corrected for a motion on the mount.
  RigidTransform<RightCamera, Camera> right_T_left() const { return drift_.right_T_left(); }
  /// Standard error of its direction, beyond the calibration's.
  double rightTurnSigma_rad() const { return drift_.turnSigma_rad(); }
  /// One line, where a motion of a camera is corrected; empty otherwise.
  std::string correction() const { return drift_.words(); }

 private:
  void followDrift();

  cameras::StereoRig rig_;
  cameras::RigMonitor monitor_;
  cameras::RigVerdict verdict_;
  CameraDrift drift_;
  std::optional<RigFault> reference_fault_;  // a session that starts with such images stays wrong
  bool has_fitted_ = false;                  // the whole reference pair fitted its calibration
  std::size_t frames_ = 0, next_feature_ = 0;
  /// Frames in a row in which a coil at rest has, or has not, the size and the rows that its print must have.
  std::size_t contradicted_ = 0, agreed_ = 0;
  bool coil_contradicts_ = false;
};

}  // namespace facenav::monitoring
