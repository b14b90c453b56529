#pragma once
// LossDetail: the cause of a loss of the head, in more detail than LostReason, for users: shown in the banner
// and in the column "detail" of poses.csv. It never affects the pose.

#include <string>

namespace facenav::head_tracking {

enum class LossDetail {
  unknown,
  not_found,         // nothing in the images resembles the face
  covered,           // part of it is at the expected place, too little for a pose
  too_far,           // something similar, but far from where it was learnt
  blurred,           // the image has lost its detail: defocus or motion
  one_camera,        // one camera sees the face, the other does not
  doubtful,          // found, but the pose is too uncertain
  frozen,            // a camera repeats its picture
  no_picture,        // black, blank, or of another size
  swapped,           // left and right exchanged
  out_of_step,       // the two images were taken at different moments: the room is in place
  cameras_moved,     // face and room are off their epipolar lines, as if a camera had moved
  cameras_disagree,  // one of these two; the room shows too little to tell which
  other_face,        // a face is there, but another person's
};

/// One word: "covered".
std::string toString(LossDetail detail);

}  // namespace facenav::head_tracking
