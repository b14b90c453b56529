#pragma once
// Mixed images: a few images of another kind (phase, real part, a map) in the places of a magnitude series.

#include <vector>

#include "facenav/dicom/series.h"
#include "series_groups.h"

namespace facenav::dicom {

/// Names images of another kind that fill the gaps of a magnitude series, or continue it at an end.
/// `series[g]` describes `groups[g]`.
void nameMixedImages(std::vector<SeriesInfo>& series, const std::vector<SliceHeader>& headers,
                     const std::vector<SeriesGroup>& groups);

}  // namespace facenav::dicom
