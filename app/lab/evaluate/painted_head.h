#pragma once
// A labelled head (modules/evaluation) as a person and as the scan of it: two paintings of the same labels,
// so that the skin of the room and the skin that the workstation finds are of one head but share no error.

#include <filesystem>
#include <optional>

#include "facenav/volume/volume.h"

namespace facenav::app {

struct PaintedHead {
  volume::Volume person;  // even tissue, sharp, hardly any noise: what the room makes the patient of
  volume::Volume scan;    // as a scanner shows it: contrast, blur, shading and noise drawn
};

/// Nothing where `nifti` does not lie in a folder of labelled heads (t1_intensities.csv beside it). The same
/// file gives the same head. Throws Error: no map of labels, damaged statistics.
std::optional<PaintedHead> paintedHead(const std::filesystem::path& nifti);

}  // namespace facenav::app
