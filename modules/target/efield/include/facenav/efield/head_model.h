#pragma once
// Makes the three surfaces of a HeadModel from a case: inner skull around the brain mask, outer skull, scalp
// from the skin. All are graded spheres of triangles about the brain's middle, so that they nest; triangles
// are smaller on top, where coils are held, and those of outer skull and scalp larger. Frame Mri, mm.

#include "facenav/efield/shell_mesh.h"
#include "facenav/surface/triangle_mesh.h"
#include "facenav/volume/volume.h"

namespace facenav::efield {

constexpr double kLeastGap_mm = 2.0;  // between two surfaces of the head

/// Pieces of an edge of the icosahedron (geodesicSphere) on outer skull and scalp: three for four of the
/// inner skull.
constexpr int outerParts(int divisions) { return divisions < 2 ? 1 << divisions : 3 << (divisions - 2); }

/// Builds the surfaces. `skin`: the case's scalp, which places the head mask's edge more accurately (may be
/// open). `divisions`: of the inner skull's icosphere; 4 gives it 2562 vertices, and the others 1442. Throws
/// Error: an empty brain mask or one in parts, one with large gaps, a scan that cuts brain or head, a brain
/// mask that reaches the skin.
HeadModel buildHeadModel(const volume::Mask& brain, const volume::Mask& head,
                         const surface::TriangleMesh& skin, int divisions = 4);

}  // namespace facenav::efield
