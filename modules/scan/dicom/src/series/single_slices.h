#pragma once
// Joins slices with a Series Instance UID each into the scan they come from. Some anonymisers (and some
// scanners' classic exports) give every file its own UIDs; series number, description, times and acquisition
// parameters still agree. Other readers trust the series number alone or join all files of a folder. Here all
// recorded attributes must agree, and ambiguous cases go to readings.h.

#include <vector>

#include "facenav/dicom/joined_slices.h"
#include "header/slice_header.h"

namespace facenav::dicom {

struct Join {
  std::vector<int> headers;  // indices, ascending
  JoinedSlices finding;
};

/// Joins slices. A UID takes part only if it covers one or two places, and at least eight such UIDs must
/// agree: two true series are never merged. Never joins across patients. Takes n log n in the slices if they
/// have few geometries.
std::vector<Join> joinSingleSlices(const std::vector<SliceHeader>& headers);

/// True if two slices agree in all attributes that slices of one scan must share (except the UIDs).
bool isOfOneScan(const SliceHeader& a, const SliceHeader& b);

/// Smallest stack that is joined, or that a reading splits into.
constexpr std::size_t kFewestJoined = 8;

}  // namespace facenav::dicom
