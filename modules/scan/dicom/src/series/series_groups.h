#pragma once
// Sorts images into volumes: by Series Instance UID and patient, and within these by attributes that separate
// volumes (orientation, matrix, spacing, echo, magnitude or phase, stack). Slices with a Series Instance UID
// each are joined first (single_slices.h).

#include <optional>
#include <vector>

#include "slice_stack.h"

namespace facenav::dicom {

struct SeriesGroup {
  std::vector<ImageRef> images;
  std::string part;                // distinguishes it from other groups of its UID; empty for the only one
  bool is_magnitude_part = false;  // `part` is magnitude
  int stacks = 1;                  // enhanced: Stack IDs that were joined to one even volume
  bool is_scattered = false;       // single images in different directions: a localizer, projections
  std::optional<JoinedSlices> joined = {};  // slices with different UIDs that were joined
};

/// Groups of one UID are neighbours in the result. A UID shared by two patients (copied or badly
/// pseudonymised files) gives groups for each. A few images that differ from a large group in geometry alone
/// stay in it: it is one damaged volume, not two. stackSlices then names them.
std::vector<SeriesGroup> groupImages(const std::vector<SliceHeader>& headers);

}  // namespace facenav::dicom
