#pragma once
// Pixel formats of GenICam cameras -> 8-bit grey.

#include <opencv2/core.hpp>
#include <string>

#include "genicam_call.h"

namespace facenav::capture {

/// The best format that the camera offers and decodeGrey reads ("Mono8" first); empty: none. `wanted`: that
/// one only.
std::string chooseGenicamFormat(ArvCamera* camera, const std::string& wanted);
/// Own memory; empty if the buffer is no whole picture of a known format.
cv::Mat decodeGrey(ArvBuffer* buffer);

}  // namespace facenav::capture
