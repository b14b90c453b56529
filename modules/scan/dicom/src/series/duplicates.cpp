#include "duplicates.h"

#include <algorithm>

#include "facenav/core/error.h"
#include "pixels/pixel_decoder.h"

namespace facenav::dicom {
namespace {

/// True if the two files are copies of one another.
bool isSameFile(const std::filesystem::path& a, const std::filesystem::path& b) {
  constexpr std::uint64_t kChunk = 1 << 20;
  const FilePrefix one(a), other(b);
  if (one.fileSize() != other.fileSize()) return false;
  std::string left, right;
  for (std::uint64_t at = 0; at < one.fileSize(); at += kChunk) {
    const std::uint64_t length = std::min(kChunk, one.fileSize() - at);
    left.resize(length);
    right.resize(length);
    if (!one.copy(at, length, left.data()) || !other.copy(at, length, right.data()) || left != right)
      return false;
  }
  return true;
}

std::vector<float> valuesOf(const SliceHeader& header, int frame) {
  FilePrefix file(header.file);
  SliceHeader fresh = header;
  fresh.layout = walkHeader(file);
  return PixelDecoder(file, fresh).image(frame);
}

}  // namespace

bool isSameImage(const std::vector<SliceHeader>& headers, ImageRef a, ImageRef b) {
  try {
    const SliceHeader &one = headers[std::size_t(a.header)], &other = headers[std::size_t(b.header)];
    if (a.frame == b.frame && isSameFile(one.file, other.file)) return true;
    return valuesOf(one, a.frame) == valuesOf(other, b.frame);
  } catch (const Error&) {
    return false;
  }
}

}  // namespace facenav::dicom
