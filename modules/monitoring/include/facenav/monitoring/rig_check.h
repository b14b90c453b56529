#pragma once
// RigCheck: feeds stereo::RigMonitor from what navigation sees anyway, so that cameras that have moved since
// their calibration are noticed at the session's start and during it, without a board: textured points of the
// face, matched anew in both directions, and the coil's marker. Some tens of microseconds a frame.

#include "facenav/monitoring/pair_fault.h"
#include "facenav/stereo/rig_monitor.h"
#include "facenav/tracking/coil_tracker.h"
#include "facenav/tracking/head_tracker.h"

namespace facenav::monitoring {

/// Points of a measured surface (Camera, mm, with their left pixels), matched anew in this pair: the check of
/// a capture before it is aligned. At most `most` of them, spread over the surface.
std::vector<stereo::Correspondence> matchSurface(const stereo::StereoRig& rig,
                                                 const stereo::StereoFrame& frame,
                                                 const PointCloud<Camera>& surface,
                                                 const std::vector<Eigen::Vector2f>& left_px,
                                                 std::size_t most = 600);

class RigCheck {
 public:
  explicit RigCheck(const stereo::StereoRig& rig) : rig_(rig), monitor_(rig) {}
  /// The reference pair of the session: asked as a whole whether it fits the rig (half a second).
  void start(const tracking::HeadReference& reference);
  void add(const stereo::StereoFrame& frame, const Tracked<tracking::HeadPose>& head,
           const std::optional<tracking::MarkerSighting>& marker);
  /// Why no pose can be trusted, as of some frames ago; empty: nothing speaks against the cameras.
  std::optional<RigFault> fault() const;

 private:
  stereo::StereoRig rig_;
  stereo::RigMonitor monitor_;
  stereo::RigVerdict verdict_;
  std::optional<RigFault> reference_fault_;  // learnt from such pictures nothing is right later on
  bool has_fitted_ = false;                  // the whole reference pair, its calibration
  std::size_t frames_ = 0, next_feature_ = 0;
};

}  // namespace facenav::monitoring
