#pragma once
// PLAN: the slices along a target's coil axis as one picture, for `facenav plan --slices`. Drawn without a
// screen.

#include "facenav/casefile/case_store.h"
#include "facenav/casefile/overlays_file.h"
#include "facenav/guidance/coil_plate.h"
#include "facenav/scene/slice_scene.h"

namespace facenav::steps {

/// The error at the target is smaller in 95 of 100 alignments like the case's, mm: at least what the
/// alignment stored for it; of a target that was planned later, the worst it stored. Nothing without an
/// alignment, or where the file does not tell.
std::optional<double> alignedBound95_mm(const casefile::CaseStore& store, const guidance::Target& target);

/// Along and across the handle, side by side, with the depths in words. `scene`: MRI, window and overlays.
RgbImage coilSliceSheet(const scene::SliceScene& scene, const guidance::Target& target,
                        const guidance::CoilPlate& plate, std::optional<double> bound95_mm);

/// The colours of a map with their values and unit, for both signs.
RgbImage mapScale(const casefile::OverlayEntry& entry);

}  // namespace facenav::steps
