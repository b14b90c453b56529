#pragma once
// LossDetail: what a loss of the head looks like, finer than LostReason and for people: the banner and the
// column "detail" of poses.csv say it. Never decides anything.

#include <string>

namespace facenav::head_tracking {

enum class LossDetail {
  unknown,
  not_found,      // nothing in the pictures looks like the face
  covered,        // part of it is where it should be, too little for a pose
  too_far,        // something like it, far from where it was learnt
  blurred,        // the picture has lost its detail: defocus, or motion
  one_camera,     // one camera sees the face, the other does not
  doubtful,       // found, but the pose is not sure enough
  frozen,         // a camera repeats its picture
  no_picture,     // black, blank, or of another size
  swapped,        // left and right exchanged
  out_of_step,    // the two pictures are of different moments
  other_rig,      // the calibration is not of these cameras
  cameras_moved,  // since their calibration
  other_face,     // a face is there, another person's
};

/// One word: "covered".
std::string toString(LossDetail detail);

}  // namespace facenav::head_tracking
