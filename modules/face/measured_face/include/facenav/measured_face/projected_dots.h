#pragma once
// Detects the projector's dots in the pictures of a capture.

#include "facenav/capture/recording.h"

namespace facenav::measured_face {

/// False if the image with dots shows no more detail than the plain one: the projector was off.
bool showsDots(const capture::CapturePair& capture);

/// True if most skin lies between the dots, as with the paper's pattern of one dot in 64 x 64. The face's
/// size is then measured less exactly. Taking dense dots for sparse ones is safe: it only widens the error
/// bound. Call showsDots() first: noise in pictures without dots can look like sparse dots.
bool areDotsSparse(const capture::CapturePair& capture);

}  // namespace facenav::measured_face
