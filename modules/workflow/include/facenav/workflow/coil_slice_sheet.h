#pragma once
// PLAN: the slices along a target's coil axis as one picture, for `facenav plan --slices`. Drawn without a
// screen.

#include "facenav/casefile/case_store.h"
#include "facenav/casefile/overlays_file.h"
#include "facenav/guidance/coil_plate.h"
#include "facenav/scene/slice_scene.h"

namespace facenav::workflow {

/// Predicted standard error at the target by the case's alignment, mm; nothing without one, or where the file
/// cannot be read.
std::optional<double> alignedError_mm(const casefile::CaseStore& store, const guidance::Target& target);

/// Along and across the handle, side by side, with the depths in words. `scene`: MRI, window and overlays.
RgbImage coilSliceSheet(const scene::SliceScene& scene, const guidance::Target& target,
                        const guidance::CoilPlate& plate, std::optional<double> error_mm);

/// The colours of a map with their values and unit, for both signs.
RgbImage mapScale(const casefile::OverlayEntry& entry);

}  // namespace facenav::workflow
