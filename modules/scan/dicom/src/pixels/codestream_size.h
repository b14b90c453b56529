#pragma once
// Width, height and components in a compressed frame itself. They are compared with the DICOM header before a
// codec runs, so that a damaged stream cannot make it allocate or write another size.

#include <optional>
#include <string_view>

namespace facenav::dicom {

struct CodestreamSize {
  long width = 0, height = 0, components = 0;
};

/// Size in JPEG and JPEG-LS (ITU-T T.81 B.2.2, T.87 C.2.2), from the first frame header; nullopt if there is
/// none.
std::optional<CodestreamSize> jpegSize(std::string_view stream);
/// Size in JPEG 2000 (ITU-T T.800 A.5.1), bare or within JP2 boxes, from SIZ; components at full resolution
/// only.
std::optional<CodestreamSize> jpeg2000Size(std::string_view stream);

}  // namespace facenav::dicom
