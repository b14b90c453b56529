#pragma once
// PairDiagnosis: the reason why a pair of pictures does not fit its calibration. Matches are found without
// the rig (pair_matches.h). The diagnosis is the simplest explanation that fits them: the calibration; left
// and right exchanged; a right camera that was knocked; any other pose of it (another rig's calibration);
// none (the two exposures are of different moments: face, hair and clothes moved apart, and no camera pose
// fits all).
//
// Corners of eyes and brows move with the skull, and may fit a moved camera by themselves. If they do,
// matches are grown over the skin, which moves relative to the skull when the face does. A head that moved
// as one rigid piece, with an unchanged expression, looks like a moved camera. Then only the room behind it
// tells the two apart. Where it shows too little, the finding names both (RigState::disagree).

#include <optional>
#include <string>
#include <vector>

#include "facenav/cameras/stereo_frame.h"
#include "facenav/cameras/stereo_rig.h"
#include "facenav/health/observation.h"
#include "facenav/health/rig_state.h"

namespace facenav::health {

/// Least standard error of one match on skin: slant of skin and compression. A noisy picture's is larger.
constexpr double kMatchSigma_px = 0.3;

struct PairDiagnosis {
  RigState state = RigState::unclear;
  std::size_t matches = 0;
  double agreement = 0;  // share of the matches that fit the best explanation
  double calibrated_agreement = 0;
  double residual_px = 0;   // median residual under the calibration
  bool is_of_face = false;  // the matches are those of the face
  double skin_px = 0;       // residual common to neighbouring skin under the best explanation; 0: not tested
  /// The best explanation's pose of the right camera (the baseline's length is the calibration's).
  RigidTransform<RightCamera, Camera> right_T_left;

  /// True if the diagnosis blames a camera's pose; only then is the skin tested.
  bool isOfCameras() const { return state == RigState::moved || state == RigState::other_cameras; }
  bool isFault() const { return health::isFault(state); }
  /// Finding and advice; empty without a fault.
  RigVerdict verdict() const;
};

/// Finding where one camera moved, or the pictures are of two moments, and nothing tells which. `off_px`:
/// distance of the matches from their epipolar lines.
RigVerdict camerasDisagree(double off_px);

/// Diagnoses matches of one pair; sigma_px of each is across the epipolar line.
PairDiagnosis diagnoseMatches(const cameras::StereoRig& rig, const std::vector<Correspondence>& matches);
/// Tests a diagnosis of moved cameras or of another rig on the skin: confirms it, or finds pictures of two
/// moments. `skin`: matches grown over the face (growMatches). Any other diagnosis is returned unchanged.
PairDiagnosis withSkin(const cameras::StereoRig& rig, PairDiagnosis diagnosis,
                       const std::vector<Correspondence>& skin);
/// Tests a diagnosis of moved cameras or of another rig of the face's matches on those of the room behind it
/// (likelierCause): the room confirms it, or says that the head moved alone, or shows too little. Then moved
/// cameras are no more than a guess, and the state is `disagree`.
PairDiagnosis withRoom(const cameras::StereoRig& rig, PairDiagnosis diagnosis,
                       const std::vector<Correspondence>& face, const std::vector<Correspondence>& room);
/// Diagnoses a pair of pictures, including the skin. Takes half a second, or a second if the rig does not
/// fit. `face_px`: outline of the face in the left picture; empty: unknown, then the whole picture counts.
/// Give it where it is known: clothes and wallpaper repeat and match in wrong places, and lie where no board
/// was shown and the lens model is a guess. If too little of the face matches, the rest can tell exchanged
/// pictures and two moments only. `moved` is said only where the calibration's own errors do not explain the
/// matches (RigMonitor), and the room says that the camera moved (likelierCause); without `face_px` the room
/// is among the matches.
PairDiagnosis diagnosePair(const cameras::StereoRig& rig, const cameras::StereoFrame& frame,
                           const std::vector<cv::Point>& face_px = {});

/// Cause of a face that is off its epipolar lines.
enum class OffsetCause {
  unknown,        // the room shows too little to tell
  camera_moved,   // face and room are off by one motion of a camera
  two_exposures,  // the room is on its lines: the head moved between the exposures
};

/// The likelier cause, by the room, which stands still: one motion of the right camera explains face and
/// room, or the room fits the calibration and the face moved alone.
OffsetCause likelierCause(const cameras::StereoRig& rig, const std::vector<Correspondence>& face,
                          const std::vector<Correspondence>& room);
/// The likelier cause in a pair of pictures. `face_px`: outline in the left picture; body and hair around it
/// do not count. Takes about 0.3 s.
OffsetCause causeOfOffset(const cameras::StereoRig& rig, const cameras::StereoFrame& frame,
                          const std::vector<cv::Point>& face_px);

}  // namespace facenav::health
