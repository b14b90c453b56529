#pragma once
// SeriesStack: the headers of a listed series, read again, and its images in order.

#include <vector>

#include "facenav/core/task_monitor.h"
#include "slice_stack.h"

namespace facenav::dicom {

struct SeriesStack {
  std::vector<SliceHeader> headers;
  SliceStack stack;
};

/// Reads the headers and orders the images. Throws Error naming the file: the series changed since it was
/// listed, or its images form no stack.
SeriesStack readStack(const SeriesInfo& series, TaskMonitor& monitor);

}  // namespace facenav::dicom
