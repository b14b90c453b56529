#pragma once
// Slices that carry a Series Instance UID each, joined to the scan they come from. Some anonymisers (and some
// scanners' classic exports) give every file UIDs of its own; series number, description, times and
// acquisition parameters still agree. Readers in use either trust the series number alone or join whatever
// lies in one folder; here everything stated must agree, and doubt is left to readings.h.

#include <vector>

#include "facenav/dicom/joined_slices.h"
#include "header/slice_header.h"

namespace facenav::dicom {

struct Join {
  std::vector<int> headers;  // indices, ascending
  JoinedSlices finding;
};

/// Only slices whose Series Instance UID covers one or two places are joined, and only where eight UIDs or
/// more agree: two true series are never made one. Never across patients. n log n in the slices where
/// their geometries are few.
std::vector<Join> joinSingleSlices(const std::vector<SliceHeader>& headers);

/// Whether two slices agree in all that slices of one scan must agree in (the UIDs aside).
bool isOfOneScan(const SliceHeader& a, const SliceHeader& b);

/// A stack of fewer slices is not put together, and not taken apart into.
constexpr std::size_t kFewestJoined = 8;

}  // namespace facenav::dicom
