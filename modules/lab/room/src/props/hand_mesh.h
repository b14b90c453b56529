#pragma once
// A hand with its forearm, which hides part of the face. Its own frame, mm.

#include "facenav/surface/triangle_mesh.h"

namespace facenav::room {

surface::TriangleMesh handMesh();

}  // namespace facenav::room
