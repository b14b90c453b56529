#pragma once
// SliceStack: images ordered along their common normal by Image Position (Patient) (PS3.3 C.7.6.2), and their
// grid, or the reason why they form none. File names, instance numbers and Slice Location are ignored.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "facenav/dicom/series.h"
#include "facenav/volume/voxel_grid.h"
#include "header/slice_header.h"

namespace facenav::dicom {

/// One image of a file: index into the headers, and the frame within it.
struct ImageRef {
  int header = 0, frame = 0;
};

struct StackFault {
  std::string what;
  std::filesystem::path file;
  std::string remedy;
  SeriesProblem kind = SeriesProblem::geometry;
};

struct SliceStack {
  std::vector<ImageRef> order;  // images along the normal; of several at one place, the first
  std::vector<std::pair<ImageRef, ImageRef>> coincident;  // further images at the place of one in `order`
  volume::VoxelGrid grid;                                 // RAS mm; valid only without a fault
  std::optional<StackFault> fault;
  std::string note;  // set if positions are so rounded that dcm2niix places slices elsewhere
};

SliceStack stackSlices(const std::vector<SliceHeader>& headers, const std::vector<ImageRef>& images);

const ImagePlace& placeOf(const std::vector<SliceHeader>& headers, ImageRef image);
/// True for the same directions within about 0.06 degrees.
bool isSameOrientation(const ImagePlace& a, const ImagePlace& b);

}  // namespace facenav::dicom
