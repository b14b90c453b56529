#pragma once
// RigState and RigVerdict: the common result of every check of a camera pair: whether the cameras are
// positioned as calibrated, and expose together. Used for matches of one pair, a board or a marker, a face
// while it is tracked, and a stored rig at its start.

#include <string>

namespace facenav::health {

enum class RigState {
  unclear,        // too little was seen
  holds,          // the calibration fits
  moved,          // one camera moved or turned against the other
  other_cameras,  // the calibration is not of these cameras, or a focus or zoom was changed
  swapped,        // left and right are exchanged
  out_of_step,    // the two pictures are of different moments
  disagree,       // moved or out_of_step: nothing tells which
  away,           // a camera is unplugged or silent
};

/// Word of a state, as in rig.json and in `facenav rig check --json`: "holds", "moved", "other_cameras",
/// "swapped", "unclear", "out_of_step", "cameras_disagree", "away".
std::string toString(RigState state);
/// State of a word; unclear for an unknown word.
RigState rigStateNamed(const std::string& word);
/// True for every state but unclear and holds.
bool isFault(RigState state);
/// True for a fault that the next pair may not have: the two pictures may be of two moments, which differ
/// only while the head moves.
bool isOfTheMoment(RigState state);
/// True if the cameras' geometry is not the calibration's: moved, other cameras, swapped.
bool isWrongGeometry(RigState state);

/// Finding of a check of a camera pair, with advice.
struct RigVerdict {
  RigState state = RigState::unclear;
  std::string finding, advice;  // "the cameras have moved ..", "calibrate again"; either may be empty

  bool isFault() const { return health::isFault(state); }
  /// One line: "finding: advice".
  std::string words() const { return advice.empty() ? finding : finding + ": " + advice; }
};

}  // namespace facenav::health
