#pragma once
// A shell as the mesh type of module surface, for its search of nearest places.

#include "facenav/efield/shell_mesh.h"
#include "facenav/surface/triangle_mesh.h"

namespace facenav::efield {

surface::TriangleMesh triangleMesh(const ShellMesh& shell);

}  // namespace facenav::efield
