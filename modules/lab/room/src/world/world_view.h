#pragma once
// Where the head is in a World, and whether both cameras see the face.

#include "facenav/room/world.h"

namespace facenav::room {

/// Pose of the seated head at a moment: a frame at the face's middle with Mri's axes.
RigidTransform<Room, Mri> facePose(const World& world, const WorldMoment& moment,
                                   const Point<Mri>& face_middle);
/// True if a face of the largest size lies inside both pictures.
bool isFaceInView(const World& world, const WorldMoment& moment);

}  // namespace facenav::room
