#pragma once
// PairDiagnosis: why a pair of pictures does not fit its calibration. Matches found without the rig
// (pair_matches.h) are asked which explanation is the simplest that holds: the calibration; the calibration
// with left and right exchanged; a right camera that was knocked; any other pose of it (another rig's
// calibration); none (the pictures are not of one moment: face, hair and clothes moved, each by itself,
// between the two exposures, and no pose of a camera brings them together).
//
// The corners of eyes and brows move with the skull and may fit a moved camera by themselves. Where a moved
// camera is what they say, matches are grown over the skin, which moves otherwise than the skull when the
// face does. Only a head that moved as one rigid piece with a face that kept its expression looks like a
// moved camera in one frame: nothing in it tells them apart, and the advice for a moved camera says so.

#include <string>
#include <vector>

#include "facenav/stereo/rig_monitor.h"
#include "facenav/stereo/stereo_frame.h"

namespace facenav::stereo {

enum class PairFault {
  unknown,      // too little is seen in both pictures
  none,         // the calibration holds
  out_of_step,  // the two pictures are of different moments
  swapped,      // left and right are exchanged
  moved,        // the right camera stands a little otherwise than calibrated
  other_rig,    // the calibration is not of these cameras
};

struct PairDiagnosis {
  PairFault fault = PairFault::unknown;
  std::size_t matches = 0;
  double agreement = 0;  // share of the matches that the best explanation holds for
  double calibrated_agreement = 0;
  double residual_px = 0;  // median, of the calibration as it is
  double skin_px = 0;      // off the best explanation's lines, as neighbouring skin shares it; 0: not asked
  /// The best explanation's pose of the right camera (the baseline's length is the calibration's).
  RigidTransform<RightCamera, Camera> right_T_left;

  /// Whether a camera's pose is said to be the cause; skin is asked then.
  bool isOfCameras() const { return fault == PairFault::moved || fault == PairFault::other_rig; }
  bool isFault() const { return fault != PairFault::unknown && fault != PairFault::none; }
  /// What happened: "the two cameras' pictures are of different moments". Empty without a fault.
  std::string words() const;
  /// What to do: "trigger both cameras together, or check cable and driver". Empty without a fault.
  std::string advice() const;
};

/// From matches of one pair, sigma_px of each across the epipolar line.
PairDiagnosis diagnoseMatches(const StereoRig& rig, const std::vector<Correspondence>& matches);
/// What skin says to a diagnosis of moved cameras or of another rig: that, or pictures of two moments.
/// `skin`: matches grown over the face (growMatches). Any other diagnosis is given back as it is.
PairDiagnosis withSkin(const StereoRig& rig, PairDiagnosis diagnosis,
                       const std::vector<Correspondence>& skin);
/// From the pictures, skin included: half a second, a second where the rig does not fit.
PairDiagnosis diagnosePair(const StereoRig& rig, const StereoFrame& frame);

}  // namespace facenav::stereo
