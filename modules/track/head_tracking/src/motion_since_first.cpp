#include "facenav/head_tracking/head_tracker.h"

namespace facenav::head_tracking {

std::function<std::optional<RigidTransform<Camera, Head>>(const cameras::StereoFrame& frame)>
motionSinceFirst(HeadTracker& tracker, const cameras::StereoRig& rig) {
  return [&tracker, rig, is_started = false](
             const cameras::StereoFrame& frame) mutable -> std::optional<RigidTransform<Camera, Head>> {
    if (!is_started) {
      tracker.start(rig, {frame, {}, {}}, Pace::patient);
      is_started = true;
      return RigidTransform<Camera, Head>();
    }
    const auto pose = tracker.track(frame);
    return pose ? std::optional(pose->camera_T_head) : std::nullopt;
  };
}

}  // namespace facenav::head_tracking
