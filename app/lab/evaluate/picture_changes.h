#pragma once
// Changes of a person's images for `facenav evaluate pairs`: mirrored into another person, and the same
// exposure under other conditions.

#include <string>
#include <vector>

#include "facenav/cameras/stereo_frame.h"
#include "facenav/cameras/stereo_rig.h"

namespace facenav::app {

/// Mirrors the person left to right, as the same rig would have seen it. This gives an exact pair of a person
/// who does not exist: nearly the same shape, but skin detail at other places. Pixels without a source are
/// black.
cameras::StereoFrame mirroredPair(const cameras::StereoRig& rig, const cameras::StereoFrame& frame);

struct ChangedPair {
  std::string change;  // "shifted by 13 px"
  cameras::StereoFrame frame;
};
/// Changes the pair: shifted, darkened, more compressed, lower face covered. `lower_face_y`: first covered
/// row, px of each image.
std::vector<ChangedPair> changedPairs(const cameras::StereoFrame& frame, int lower_face_y_left,
                                      int lower_face_y_right);

}  // namespace facenav::app
