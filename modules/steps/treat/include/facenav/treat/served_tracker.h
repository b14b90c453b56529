#pragma once
// Poses of the coil, and of the head, from another tracker by OpenIGTLink instead of the cameras
// (links/igtl_client.h). With the head from the cameras it must be known how that tracker stands to them.
// If both come from the other tracker there are no cameras: Camera is then that tracker's frame, Head its
// tool on the head, and an alignment from a file ties the head to the MRI (tracker_alignment.h).

#include <filesystem>
#include <memory>
#include <string>

#include "facenav/capture/frame_source.h"
#include "facenav/coil_tracking/coil_tracker.h"
#include "facenav/head_tracking/head_tracker.h"

namespace facenav::steps {

/// Reads how the tracker stands to the left camera: a JSON file with the key camera_T_tracker (16 numbers,
/// row by row, mm). Throws Error that names file and key, also for a pose that is not rigid.
Eigen::Isometry3d readTrackerPose(const std::filesystem::path& path);

/// Makes a tracker of the coil that reads `words`, "igtl://HOST[:PORT]/NAME". The pose NAME maps Coil (origin
/// the centre of the contact face) to the other tracker's frame. Throws Error for other words, or a host that
/// is not known.
std::unique_ptr<coil_tracking::CoilTracker> makeServedCoilTracker(const std::string& words,
                                                                  const Eigen::Isometry3d& camera_T_tracker);

/// Trackers of one server that read head and coil of the same moment.
struct ServedTrackers {
  std::unique_ptr<head_tracking::HeadTracker> head;
  std::unique_ptr<coil_tracking::CoilTracker> coil, second_coil;  // second_coil: null without one
};
/// `words`: as above, for the coil; `head`, `second_coil`: names of their poses at the same server; empty
/// `second_coil`: there is none. Throws as above.
ServedTrackers makeServedTrackers(const std::string& words, const std::string& head,
                                  const std::string& second_coil = {});

/// Frames without pictures, at 60 a second, for a session without cameras. `rig` of the source is none that
/// exists: its pictures are black and have a few pixels.
std::unique_ptr<capture::FrameSource> makeFramesWithoutPictures();

}  // namespace facenav::steps
