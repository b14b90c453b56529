#pragma once
// Makes the surface between the brain and the fluid round it for a HeadModel of four compartments: the case's
// cortex with its open sulci, as coarsely as the field solver bears. Sulci narrower than about an edge of the
// mesh close. Frame Mri, mm.

#include "facenav/efield/shell_mesh.h"
#include "facenav/surface/triangle_mesh.h"

namespace facenav::efield {

constexpr double kLeastFluid_mm = 1.0;  // between the brain and the inner skull

struct BrainSurfaceOptions {
  int most_vertices = 14000;  // the equations' memory and time grow with its square and cube
  double finest_mm = 2.5;     // edge of the cells that hold one vertex each
};

/// Builds the surface from the cortex (closed, outwards) within the inner skull. The lower third of the brain
/// gets no sulci: no coil stands there. Throws Error: no brain within the skull, or one that does not keep
/// kLeastFluid_mm from it.
ShellMesh brainSurface(const surface::TriangleMesh& cortex, const ShellMesh& inner_skull,
                       const BrainSurfaceOptions& options = {});

}  // namespace facenav::efield
