#pragma once
// A labelled head (modules/lab/evaluation) as a person and as the scan of it: two paintings of the same
// labels, so that the skin of the room and the skin that the workstation finds are of one head but share no
// error.

#include <filesystem>
#include <optional>

#include "facenav/volume/volume.h"

namespace facenav::app {

struct PaintedHead {
  volume::Volume person;  // uniform tissue, sharp, hardly any noise: input of the room's patient
  volume::Volume scan;    // scan with random contrast, blur, shading and noise
};

/// Paints the head; the same file gives the same head. Returns nothing if `nifti` is not in a folder of
/// labelled heads (t1_intensities.csv beside it). Throws Error: no map of labels, damaged statistics.
std::optional<PaintedHead> paintedHead(const std::filesystem::path& nifti);

}  // namespace facenav::app
