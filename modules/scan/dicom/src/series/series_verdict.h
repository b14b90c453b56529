#pragma once
// Verdict on one group of images: whether it forms a volume, and if not, why; its contrast; its fitness for
// navigation.

#include "facenav/dicom/series.h"
#include "series_groups.h"

namespace facenav::dicom {

/// Describes one group. Reads pixels only to distinguish duplicates from different images at one place.
SeriesInfo describeGroup(const std::vector<SliceHeader>& headers, const SeriesGroup& group);

/// Sets `is_fit_for_navigation` and `fitness` by what is known of a loadable series.
void judgeFitness(SeriesInfo& info);

/// Score as the navigation T1; 0 or less: unsuitable.
double navigationScore(const SeriesInfo& info);

/// Contrast from description and timing: "T1", "T2", "FLAIR", ..; empty: unknown.
std::string contrastOf(const SliceHeader& header, double echo_time_ms);

}  // namespace facenav::dicom
