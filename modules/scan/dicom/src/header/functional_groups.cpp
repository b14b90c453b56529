// Enhanced multi-frame images: position of each frame from its functional groups (PS3.3 C.7.6.16); the shared
// groups are read first.

#include <gdcmDataSet.h>

#include <algorithm>

#include "slice_header.h"
#include "tag_values.h"

namespace facenav::dicom {
namespace {

void applyGroups(const gdcm::DataSet& groups, ImagePlace& place) {
  if (const auto macro = item(groups, {0x0020, 0x9113})) readPosition(*macro, place);
  if (const auto macro = item(groups, {0x0020, 0x9116})) readOrientation(*macro, place);
  if (const auto macro = item(groups, {0x0028, 0x9110})) readSpacing(*macro, place);
  if (const auto macro = item(groups, {0x0028, 0x9145})) readRescale(*macro, place);
  if (const auto macro = item(groups, {0x0018, 0x9114}))
    place.echo_time_ms = number(*macro, {0x0018, 0x9082}).value_or(place.echo_time_ms);
  if (const auto macro = item(groups, {0x0018, 0x9226})) {
    place.kind = text(*macro, {0x0008, 0x9007});
    const std::string component = text(*macro, {0x0008, 0x9208});
    if (!component.empty()) place.kind += "\\" + component;
  }
  if (const auto macro = item(groups, {0x0020, 0x9111})) {
    place.stack = text(*macro, {0x0020, 0x9056});
    place.time_index = integer(*macro, {0x0020, 0x9128}, place.time_index);
  }
  // Philips stores its scale slope in a private per-frame item beside the public rescale.
  if (const auto philips = item(groups, {0x2005, 0x140F}); philips && number(*philips, {0x2005, 0x100E})) {
    const double scale = *number(*philips, {0x2005, 0x100E});
    if (scale > 0 && place.slope != 0) {
      place.intercept /= place.slope * scale;
      place.slope = 1.0 / scale;
    }
  }
}

}  // namespace

std::vector<ImagePlace> framePlaces(const gdcm::DataSet& data, const ImagePlace& classic, int frames) {
  ImagePlace shared = classic;
  if (const auto groups = item(data, {0x5200, 0x9229})) applyGroups(*groups, shared);
  const std::vector<gdcm::DataSet> per_frame = items(data, {0x5200, 0x9230});
  const std::size_t described = std::min<std::size_t>(per_frame.size(), std::size_t(std::max(0, frames)));
  if (described == 0) return {shared};
  std::vector<ImagePlace> places(described, shared);
  for (std::size_t f = 0; f < described; ++f) applyGroups(per_frame[f], places[f]);
  return places;
}

}  // namespace facenav::dicom
