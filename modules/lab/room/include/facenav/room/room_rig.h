#pragma once
// The room's cameras. Scenarios are written in the frame `Room`: origin midway between the cameras, x right,
// y down (gravity), z forward to the patient, as seen from the cameras; mm. A rig may be rolled in the room.

#include <cstdint>

#include "facenav/cameras/projector_model.h"
#include "facenav/cameras/stereo_rig.h"
#include "facenav/core/field.h"

namespace facenav::room {

struct Room {};  // frame tag

struct RigOptions {
  int width_px = 640, height_px = 480;
  double focal_px = 800.0, baseline_mm = 120.0, convergence_deg = 10.0, roll_deg = 0.0;
  double k1 = -0.18, k2 = 0.10, p1 = 0.0007, p2 = -0.0005, k3 = 0.0;

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor(Field{"width_px", "image width", 64, 8192}, self.width_px);
    visitor(Field{"height_px", "image height", 64, 8192}, self.height_px);
    visitor(Field{"focal_px", "focal length", 50, 20000}, self.focal_px);
    visitor(Field{"baseline_mm", "distance between the cameras", 5, 2000}, self.baseline_mm);
    visitor(Field{"convergence_deg", "angle between the optical axes", -30, 90}, self.convergence_deg);
    visitor(
        Field{"roll_deg", "roll of the whole rig about its view (90: one camera above the other)", -180, 180},
        self.roll_deg);
    visitor(Field{"k1", "radial distortion of the left camera; the right one's is a tenth weaker", -1, 1},
            self.k1);
    visitor(Field{"k2", "radial distortion, 4th order", -2, 2}, self.k2);
    visitor(Field{"k3", "radial distortion, 6th order", -5, 5}, self.k3);
    visitor(Field{"p1", "tangential distortion", -0.05, 0.05}, self.p1);
    visitor(Field{"p2", "tangential distortion", -0.05, 0.05}, self.p2);
  }
};

/// Cameras close to a face: 1024 x 1024, focal length 1550 px, 114 mm and 20 deg apart; for a head at
/// kCloseHead_mm.
RigOptions closeRig();
constexpr double kCloseHead_mm = 560.0;

/// Random rig, as another clinic might build it: f 600-1000 px, baseline 60-200 mm, rolled up to 20 degrees,
/// toed in between half and all of the way to a head at 600 mm, barrel or slight pincushion lenses. The same
/// seed gives the same rig.
RigOptions randomRig(std::uint64_t seed);

/// Two cameras with slightly different focal length, principal point, distortion and roll, like real ones.
cameras::StereoRig makeRig(const RigOptions& options);

/// Camera from Room for any rig. Room's axes are the mean of the cameras' axes with the rig's roll removed.
RigidTransform<Camera, Room> cameraFromRoom(const cameras::StereoRig& rig, double roll_deg = 0.0);

/// The room's projector, above the cameras: 1024 x 768, without distortion.
cameras::ProjectorModel roomProjector(const RigidTransform<Camera, Room>& camera_T_room);

}  // namespace facenav::room
