#pragma once
// FileLayout: where things lie in a DICOM file (PS3.10 chapter 7, PS3.5 chapter 7), found by walking the
// lengths of its elements and nothing else. GDCM is given only bytes that passed this walk: on damaged
// lengths GDCM 3.0.21 allocates gigabytes, recurses without limit or reads past the end.

#include <cstdint>
#include <string>
#include <vector>

#include "file_prefix.h"

namespace facenav::dicom {

struct ByteRange {
  std::uint64_t offset = 0, length = 0;
};

struct FileLayout {
  std::string transfer_syntax;  // UID; guessed from the first element where the file has no meta header
  bool is_explicit = true, is_big_endian = false;
  std::uint64_t data_set_start = 0;
  std::uint64_t header_end = 0;  // Pixel Data's tag, or the end of the data set
  bool has_pixels = false, is_encapsulated = false;
  bool is_float = false;          // Float or Double Float Pixel Data
  bool is_pixel_vr_word = false;  // OW: big endian bytes are swapped in pairs even for 8-bit voxels
  ByteRange pixels;               // native: the value; encapsulated: starts at the first item
  bool is_truncated = false;      // native pixels end behind the file's end
  bool is_deflated = false;       // the offsets are those of the inflated bytes
};

/// True where the first bytes can be DICOM's: preamble, or a plausible first element without one.
bool looksLikeDicom(FilePrefix& file);

/// Throws Error naming the file when an element ends behind the file, nesting is absurd, a VR does not exist,
/// .. A deflated data set is inflated into `file` first.
FileLayout walkHeader(FilePrefix& file);

/// The fragments of encapsulated pixel data; the first is the Basic Offset Table. Reads the whole pixel data.
/// Throws Error naming the file when they are cut off.
std::vector<ByteRange> walkFragments(FilePrefix& file, const FileLayout& layout);

}  // namespace facenav::dicom
