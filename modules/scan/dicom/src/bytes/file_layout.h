#pragma once
// FileLayout: offsets within a DICOM file (PS3.10 chapter 7, PS3.5 chapter 7), found by walking the lengths
// of its elements. GDCM gets only bytes that passed this walk: on damaged lengths GDCM 3.0.21 allocates
// gigabytes, recurses without limit or reads past the end.

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
  std::uint64_t header_end = 0;  // offset of Pixel Data's tag, or end of the data set
  bool has_pixels = false, is_encapsulated = false;
  bool is_float = false;          // Float or Double Float Pixel Data
  bool is_pixel_vr_word = false;  // OW: big endian bytes are swapped in pairs even for 8-bit voxels
  ByteRange pixels;               // native: the value; encapsulated: from the first item
  bool is_truncated = false;      // native pixels reach past the file's end
  bool is_deflated = false;       // offsets refer to the inflated bytes
};

/// True if the first bytes may be DICOM: preamble, or a plausible first element without one.
bool looksLikeDicom(FilePrefix& file);

/// Finds the offsets. Throws Error naming the file when an element reaches past the file's end, nesting is
/// too deep, a VR does not exist, .. A deflated data set is inflated into `file` first.
FileLayout walkHeader(FilePrefix& file);

/// Fragments of encapsulated pixel data; the first is the Basic Offset Table. Reads the whole pixel data.
/// Throws Error naming the file when they are cut off.
std::vector<ByteRange> walkFragments(FilePrefix& file, const FileLayout& layout);

}  // namespace facenav::dicom
