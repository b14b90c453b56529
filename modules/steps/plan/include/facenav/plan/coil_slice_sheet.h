#pragma once
// PLAN: the slices along a target's coil axis as one picture, for `facenav plan --slices`. Needs no screen.

#include "facenav/casefile/case_store.h"
#include "facenav/casefile/overlays_file.h"
#include "facenav/guidance/coil_plate.h"
#include "facenav/scene/slice_scene.h"

namespace facenav::steps {

/// 95 % bound of the error at the target for alignments like the case's, mm: at least the value stored with
/// the alignment; for a target planned later, the largest stored one. Nothing without an alignment, or if the
/// file lacks it.
std::optional<double> alignedBound95_mm(const casefile::CaseStore& store, const guidance::Target& target);

/// Draws the slices along and across the handle side by side, with the depths in words. `scene`: MRI, window
/// and overlays.
RgbImage coilSliceSheet(const scene::SliceScene& scene, const guidance::Target& target,
                        const guidance::CoilPlate& plate, std::optional<double> bound95_mm);

/// Draws the colours of a map with their values and unit, for both signs.
RgbImage mapScale(const casefile::OverlayEntry& entry);

}  // namespace facenav::steps
