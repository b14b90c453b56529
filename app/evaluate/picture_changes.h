#pragma once
// Pictures of a person changed as `facenav evaluate pairs` needs them: another person made of him, and the
// same exposure as other circumstances would have shown it.

#include <string>
#include <vector>

#include "facenav/cameras/stereo_frame.h"
#include "facenav/cameras/stereo_rig.h"

namespace facenav::app {

/// The person mirrored left to right, as the same rig would have seen him: an exact pair of a person who does
/// not exist, of nearly the same shape, with his skin's detail elsewhere. Black where nothing was seen.
cameras::StereoFrame mirroredPair(const cameras::StereoRig& rig, const cameras::StereoFrame& frame);

struct ChangedPair {
  std::string change;  // "shifted by 13 px"
  cameras::StereoFrame frame;
};
/// Both pictures shifted, darker, coarser compressed, and with the lower face covered. `lower_face_y`: rows
/// from there on are covered, px of each picture.
std::vector<ChangedPair> changedPairs(const cameras::StereoFrame& frame, int lower_face_y_left,
                                      int lower_face_y_right);

}  // namespace facenav::app
