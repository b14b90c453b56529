#pragma once
// A patient without an MRI: an ellipsoid of a head's size. Fast, and needs no files.

#include "facenav/room/room_rig.h"
#include "facenav/room/virtual_patient.h"
#include "optics/shapes.h"

namespace facenav::testing {

inline std::shared_ptr<const room::VirtualPatient> eggPatient() {
  TaskMonitor monitor;
  return std::make_shared<const room::VirtualPatient>(
      room::makePatient(room::ellipsoid({2.0, 5.0, -10.0}, {75.0, 95.0, 110.0}, 60), {}, monitor));
}

/// Rig with small images, which make tests of poses fast.
inline room::RigOptions smallRig() {
  room::RigOptions rig;
  rig.width_px = 160;
  rig.height_px = 120;
  rig.focal_px = 200.0;
  return rig;
}

}  // namespace facenav::testing
