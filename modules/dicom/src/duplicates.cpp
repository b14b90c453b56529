#include "duplicates.h"

#include "facenav/core/error.h"
#include "pixel_decoder.h"

namespace facenav::dicom {
namespace {

std::vector<float> valuesOf(const SliceHeader& header, int frame) {
  FilePrefix file(header.file);
  SliceHeader fresh = header;
  fresh.layout = walkHeader(file);
  return PixelDecoder(file, fresh).image(frame);
}

}  // namespace

bool isSameImage(const std::vector<SliceHeader>& headers, ImageRef a, ImageRef b) {
  try {
    return valuesOf(headers[std::size_t(a.header)], a.frame) ==
           valuesOf(headers[std::size_t(b.header)], b.frame);
  } catch (const Error&) {
    return false;
  }
}

}  // namespace facenav::dicom
