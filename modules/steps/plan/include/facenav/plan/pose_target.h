#pragma once
// PLAN: the places under a given pose of the coil, for targets that were not planned on the head: an expert's
// pose, a target of another program.

#include "facenav/casefile/case_store.h"

namespace facenav::steps {

/// Point where the coil's axis meets the brain; else on the axis at `otherwise_mm` below the contact face, by
/// default the usual depth of the cortex.
Point<Mri> cortexOnAxis(const casefile::CaseStore& store, const RigidTransform<Mri, Coil>& mri_T_coil,
                        std::optional<double> otherwise_mm = {});
/// Finds the point by a brain that was read before; null: there is none.
Point<Mri> cortexOnAxis(const surface::BrainModel* brain, const RigidTransform<Mri, Coil>& mri_T_coil,
                        std::optional<double> otherwise_mm = {});
/// Point where the coil's axis meets the skin near its contact face; else the contact face's centre.
Point<Mri> skinOnAxis(const surface::ScalpSurface& scalp, const RigidTransform<Mri, Coil>& mri_T_coil);

}  // namespace facenav::steps
