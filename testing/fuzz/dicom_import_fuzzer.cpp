// libFuzzer target on the importer's inside: the walk of the lengths, GDCM's parser behind it, the decoders.
// Built by -DFACENAV_BUILD_FUZZERS=ON with clang only:
//   cmake -B build/fuzz -DCMAKE_CXX_COMPILER=clang++ -DFACENAV_BUILD_FUZZERS=ON && ninja -C build/fuzz
//   dicom_import_fuzzer build/fuzz/bin/dicom_import_fuzzer -runs=100000 -max_len=65536 corpus/
//   ../shared/data/dicom_variety/pydicom

#include <cstdint>

#include "facenav/core/error.h"
#include "pixels/pixel_decoder.h"
#include "series/slice_stack.h"

namespace {

void readAll(const std::uint8_t* bytes, std::size_t size) {
  using namespace facenav::dicom;
  FilePrefix file("fuzz", std::string(reinterpret_cast<const char*>(bytes), size));
  auto header = readSliceHeader(file);
  if (!header) return;
  std::vector<ImageRef> images;
  for (std::size_t f = 0; f < header->images.size(); ++f) images.push_back({0, int(f)});
  const std::vector<SliceHeader> headers{*header};
  stackSlices(headers, images);
  if (voxelProblem(*header).empty()) PixelDecoder(file, *header).image(0);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  try {
    readAll(bytes, size);
  } catch (const facenav::Error&) {
    // the only allowed failure
  }
  return 0;
}
