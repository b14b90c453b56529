#pragma once
// Draws stored poses over the camera pictures of their frame, for review: the scalp's outline and the target
// at the head's pose, and the coil's plate, handle and axis at the coil's pose. A person checks whether poses
// and pictures agree. An unknown pose is not drawn.

#include <optional>
#include <string>

#include "facenav/cameras/stereo_frame.h"
#include "facenav/cameras/stereo_rig.h"
#include "facenav/guidance/coil_plate.h"
#include "facenav/guidance/target.h"
#include "facenav/pictures/camera_picture.h"
#include "facenav/surface/triangle_mesh.h"

namespace facenav::pictures {

struct StoredPoses {
  std::optional<RigidTransform<Camera, Mri>> camera_T_mri;
  std::optional<RigidTransform<Camera, Coil>> camera_T_coil;
  std::optional<guidance::Target> target;
  std::string loss;  // why a pose is unknown; drawn at the top
};

/// Draws the poses. `scalp` (Mri, mm) may be empty. The pictures are 8-bit grey, of the rig's size.
CameraOverlay drawPoses(const cameras::StereoRig& rig, const cameras::StereoFrame& frame,
                        const StoredPoses& poses, const surface::TriangleMesh& scalp,
                        const guidance::CoilPlate& plate);

}  // namespace facenav::pictures
