#pragma once
// The ways to read joined slices (single_slices.h). One, where they make an even stack and nothing speaks
// against it. Several, where different images lie at one place, where the stack is uneven or denser than the
// slices say, and acquisition number, time, folder or instance numbers take it apart into whole stacks: two
// repetitions, two interleaved scans. Which is meant only a person knows.

#include <vector>

#include "series_groups.h"

namespace facenav::dicom {

/// The group itself, or, where it can be read in several ways, the group ("all slices") and one group for
/// each stack of each other reading; `joined->readings` of each then says how many can be chosen from.
/// `group.joined` is set. Reads pixels only where images lie at one place.
std::vector<SeriesGroup> readingsOf(const std::vector<SliceHeader>& headers, const SeriesGroup& group);

}  // namespace facenav::dicom
