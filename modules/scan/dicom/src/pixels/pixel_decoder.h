#pragma once
// PixelDecoder: the rescaled values of one file's images. Native data are read from the bytes directly. RLE,
// JPEG, JPEG-LS and JPEG 2000 are decoded by GDCM's codecs, one frame at a time.

#include <vector>

#include "header/slice_header.h"

namespace facenav::dicom {

/// Place of GDCM's codecs: one child process per image (isolated_codec.h), or this process if it is already
/// such a child.
enum class Isolation { each_image, none };

class PixelDecoder {
 public:
  /// Throws Error naming the file: pixels missing, cut off, colour, unsupported, ..
  PixelDecoder(FilePrefix& file, const SliceHeader& header, Isolation isolation = Isolation::each_image);
  /// Decodes image `frame` (from 0): rows x columns values, slope * stored + intercept.
  std::vector<float> image(int frame) const;
  /// Decodes into `out`, which has room for rows x columns values. `scratch` keeps the stored bytes, so that
  /// one buffer serves all images of a series.
  void decode(int frame, float* out, std::string& scratch) const;

 private:
  struct Raw {
    std::string_view bytes;
    int bits = 16;  // bits of one voxel in `bytes`
    bool is_big_endian = false;
  };
  Raw raw(int frame, std::string& scratch) const;
  std::string frameStream(int frame) const;
  std::size_t imageBytes() const;
  [[noreturn]] void refuse(const std::string& what) const;

  FilePrefix& file_;
  const SliceHeader& header_;
  Isolation isolation_;
  std::vector<ByteRange> fragments_;
};

/// Reason, from the header alone, why the voxels of this file cannot be read; empty if they can.
std::string voxelProblem(const SliceHeader& header);
/// True if the voxels are compressed: GDCM's codecs read them.
bool usesForeignCodec(const SliceHeader& header);

}  // namespace facenav::dicom
