#pragma once
// ProjectorModel: a calibrated projector, as in projector.yml. Its lens is modelled as a camera's with the
// light reversed: the pixel of a point is the one to light in order to hit it.

#include <filesystem>

#include "facenav/cameras/stereo_rig.h"

namespace facenav::cameras {

struct ProjectorModel {
  int width_px = 0, height_px = 0;  // size of the picture that it shows
  CameraModel lens;
  RigidTransform<Projector, Camera> projector_T_camera;
};

/// Reads projector.yml: `image_width image_height K D R T` (OpenCV FileStorage; T in mm, x_projector =
/// R x_camera + T, x_camera in the left camera's frame). Throws Error naming the file and the key.
ProjectorModel readProjector(const std::filesystem::path& path);
/// Writes the whole file or nothing.
void writeProjector(const ProjectorModel& projector, const std::filesystem::path& path);

}  // namespace facenav::cameras
