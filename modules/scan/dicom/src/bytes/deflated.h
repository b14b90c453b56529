#pragma once
// Deflated Explicit VR Little Endian (PS3.5 A.5): the data set behind the meta header is a raw deflate
// stream.

#include <string_view>

#include "file_prefix.h"

namespace facenav::dicom {

inline constexpr std::string_view kDeflatedSyntax = "1.2.840.10008.1.2.1.99";

/// Replaces the file's bytes from `data_set_start` on by their inflated form. Throws Error naming the file
/// when the stream is damaged or inflates to more than 4 GB.
void inflateDataSet(FilePrefix& file, std::uint64_t data_set_start);

}  // namespace facenav::dicom
