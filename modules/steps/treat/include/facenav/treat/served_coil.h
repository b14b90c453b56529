#pragma once
// The coil's pose from another tracker instead of the cameras (links/igtl_client.h). The head's pose is still
// that of the cameras, so it must be known how the tracker stands to them.

#include <filesystem>
#include <memory>
#include <string>

#include "facenav/coil_tracking/coil_tracker.h"

namespace facenav::steps {

/// Reads how the tracker stands to the left camera: a JSON file with the key camera_T_tracker (16 numbers,
/// row by row, mm). Throws Error that names file and key, also for a pose that is not rigid.
Eigen::Isometry3d readTrackerPose(const std::filesystem::path& path);

/// Makes a tracker of the coil that reads `words`, "igtl://HOST[:PORT]/NAME". The pose NAME maps Coil (origin
/// the centre of the contact face) to the other tracker's frame. Throws Error for other words, or a host that
/// is not known.
std::unique_ptr<coil_tracking::CoilTracker> makeServedCoilTracker(const std::string& words,
                                                                  const Eigen::Isometry3d& camera_T_tracker);

}  // namespace facenav::steps
