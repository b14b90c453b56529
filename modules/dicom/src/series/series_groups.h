#pragma once
// Images sorted into the volumes they belong to: by Series Instance UID and patient, and within these by what
// tells volumes apart (orientation, matrix, spacing, echo, magnitude or phase, stack). Slices that carry a
// Series Instance UID each are joined first (single_slices.h).

#include <optional>
#include <vector>

#include "slice_stack.h"

namespace facenav::dicom {

struct SeriesGroup {
  std::vector<ImageRef> images;
  std::string part;                // what tells it from the other groups of its UID; empty for the only one
  bool is_magnitude_part = false;  // `part` says so
  bool is_scattered = false;       // single images in different directions: a localizer, projections
  std::optional<JoinedSlices> joined = {};  // its slices carry UIDs of their own
};

/// Groups of one UID are neighbours in the result; a UID that two patients share (copied or badly
/// pseudonymised files) gives groups of either. A few images that differ from a large group in geometry
/// alone stay in it (it is damaged, not two volumes): stackSlices then names them.
std::vector<SeriesGroup> groupImages(const std::vector<SliceHeader>& headers);

}  // namespace facenav::dicom
