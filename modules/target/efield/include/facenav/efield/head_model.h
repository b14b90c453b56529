#pragma once
// Makes the three surfaces of a HeadModel from a case: inner skull around the brain mask, outer skull, scalp
// from the skin. All are graded icospheres about the brain's middle, with the same directions, so that they
// nest; triangles are smaller on top, where coils are held. Frame Mri, mm.

#include "facenav/efield/shell_mesh.h"
#include "facenav/surface/triangle_mesh.h"
#include "facenav/volume/volume.h"

namespace facenav::efield {

constexpr double kLeastGap_mm = 2.0;  // between two surfaces of the head

/// Builds the surfaces. `skin`: the case's scalp, which places the head mask's edge more accurately (may be
/// open). `divisions`: of the icosphere; 4 gives 2562 vertices a surface. Throws Error: an empty brain mask
/// or one in parts, one with large gaps, a scan that cuts brain or head, a brain mask that reaches the skin.
HeadModel buildHeadModel(const volume::Mask& brain, const volume::Mask& head,
                         const surface::TriangleMesh& skin, int divisions = 4);

}  // namespace facenav::efield
