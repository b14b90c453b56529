#pragma once
// RigCheck: feeds cameras::RigMonitor from what navigation sees anyway, so that cameras that have moved since
// their calibration are noticed at the session's start and during it, without a board: textured points of the
// face, matched anew in both directions, and the coil's marker. Some tens of microseconds a frame.

#include "facenav/cameras/rig_monitor.h"
#include "facenav/coil_tracking/coil_tracker.h"
#include "facenav/head_tracking/head_tracker.h"
#include "facenav/monitoring/pair_fault.h"

namespace facenav::monitoring {

/// Points of a measured surface (Camera, mm, with their left pixels), matched anew in this pair: the check of
/// a capture before it is aligned. At most `most` of them, spread over the surface.
std::vector<cameras::Correspondence> matchSurface(const cameras::StereoRig& rig,
                                                  const cameras::StereoFrame& frame,
                                                  const PointCloud<Camera>& surface,
                                                  const std::vector<Eigen::Vector2f>& left_px,
                                                  std::size_t most = 600);

class RigCheck {
 public:
  explicit RigCheck(const cameras::StereoRig& rig) : rig_(rig), monitor_(rig) {}
  /// The reference pair of the session: asked as a whole whether it fits the rig (half a second).
  void start(const head_tracking::HeadReference& reference);
  void add(const cameras::StereoFrame& frame, const Tracked<head_tracking::HeadPose>& head,
           const std::optional<coil_tracking::MarkerSighting>& marker);
  /// Why no pose can be trusted, as of some frames ago; empty: nothing speaks against the cameras.
  std::optional<RigFault> fault() const;

 private:
  cameras::StereoRig rig_;
  cameras::RigMonitor monitor_;
  cameras::RigVerdict verdict_;
  std::optional<RigFault> reference_fault_;  // learnt from such pictures nothing is right later on
  bool has_fitted_ = false;                  // the whole reference pair, its calibration
  std::size_t frames_ = 0, next_feature_ = 0;
};

}  // namespace facenav::monitoring
