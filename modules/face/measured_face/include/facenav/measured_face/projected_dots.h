#pragma once
// What the pictures of a capture show of the projector's dots.

#include "facenav/capture/recording.h"

namespace facenav::measured_face {

/// False if the image with dots shows no more detail than the plain one: the projector was off.
bool showsDots(const capture::CapturePair& capture);

/// True if the dots lie so far apart that most skin lies between them, as with the paper's pattern of one dot
/// in 64 x 64. The face's size is measured less exactly there. Dense dots that are taken for sparse ones only
/// make the stated bound wider. Ask showsDots() first: noise in pictures without dots can look like sparse
/// ones.
bool areDotsSparse(const capture::CapturePair& capture);

}  // namespace facenav::measured_face
