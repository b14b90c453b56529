#pragma once
// Conversion of GenICam pixel formats to 8-bit grey.

#include <opencv2/core.hpp>
#include <string>

#include "genicam_call.h"

namespace facenav::capture {

/// Best format that the camera offers and decodeGrey reads ("Mono8" first); empty: none. `wanted`: only that
/// one.
std::string chooseGenicamFormat(ArvCamera* camera, const std::string& wanted);
/// Decodes into memory of its own; empty if the buffer is no whole picture of a known format.
cv::Mat decodeGrey(ArvBuffer* buffer);

}  // namespace facenav::capture
