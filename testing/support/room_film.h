#pragma once
// A short sequence of the virtual room with its truth and the initial data of the trackers, for tests and
// benchmarks of the head and coil trackers on a whole face.

#include <memory>
#include <vector>

#include "facenav/coil_tracking/coil_tracker.h"
#include "facenav/head_tracking/head_tracker.h"
#include "facenav/room/synthetic_source.h"

namespace facenav::testing {

struct RoomFilm {
  cameras::StereoRig rig;
  head_tracking::HeadReference reference;
  coil_tracking::CoilModel coil;
  RigidTransform<Camera, Mri> at_reference;
  Point<Mri> target;  // in the cortex
  std::vector<std::shared_ptr<const cameras::StereoFrame>> frames;
  std::vector<room::GroundTruth> truth;

  /// Error of a pose at the target, relative to the reference, so without the alignment's error.
  double errorAtTarget_mm(const head_tracking::HeadPose& pose, std::size_t frame) const;
};

/// Renders the sequence. The reference's surface is measured from the dots, as in the alignment.
RoomFilm filmed(const room::ScenarioOptions& options, std::shared_ptr<const room::VirtualPatient> patient,
                const face::FaceDetector& detector);

}  // namespace facenav::testing
