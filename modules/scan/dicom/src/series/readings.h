#pragma once
// The ways to read joined slices (single_slices.h). There is one reading if they form an even stack and
// nothing contradicts it. There are several if different images lie at one place, or if the stack is uneven
// or denser than the slices' tags allow, and acquisition number, time, folder or instance numbers split it
// into whole stacks: two repetitions, two interleaved scans. Only a person knows which one is meant.

#include <vector>

#include "series_groups.h"

namespace facenav::dicom {

/// Returns the group itself. If it can be read in several ways: the group ("all slices") and one group for
/// each stack of each other reading; `joined->readings` of each then gives the number of readings.
/// `group.joined` must be set. Reads pixels only where images lie at one place.
std::vector<SeriesGroup> readingsOf(const std::vector<SliceHeader>& headers, const SeriesGroup& group);

}  // namespace facenav::dicom
