#pragma once
// CoilSearch: the coil anywhere in the frame, a bounded part of the work a frame. A coil that stays lost is
// looked for in one image at a time, by turns, and in the other only when that one shows a marker: half the
// time, and found one frame later at most. Every third of these frames is for dim light, so that each image
// has had its turn within six. What a frame has no room for is done in the next, in its pictures.

#include <vector>

#include "coil_fit.h"
#include "marker_detection.h"

namespace facenav::coil_tracking {

class CoilSearch {
 public:
  struct Found {
    std::vector<CoilFit> good;  // at different places
    bool is_seen_in_left = false, is_seen_in_right = false;
    bool isSeen() const { return (is_seen_in_left && is_seen_in_right) || !good.empty(); }
  };

  /// In a frame in which the coil is not where it was expected. Adds to `work`.
  Found seek(const CoilSetup& setup, const cameras::StereoFrame& frame, FrameWork& work);
  /// The frame has shown the coil, or cannot be looked at.
  void end() { *this = {}; }
  /// What it takes to go on from the last frame, where that had no room for it.
  FrameWork deferred() const { return {deferred_looks_}; }

 private:
  /// A marker seen in one image, and the poses that this allows.
  struct Candidate {
    MarkerDetection seen;
    bool is_left;
    std::vector<CoilToCamera> poses;
  };

  /// Whether the image shows any.
  bool look(const CoilSetup& setup, const cameras::StereoFrame& frame, bool is_left, MarkerLight light,
            Found& found, FrameWork& work);
  /// All, or none and they are put off.
  void fit(const CoilSetup& setup, const cameras::StereoFrame& frame, std::vector<Candidate> candidates,
           Found& found, FrameWork& work);

  int turn_ = 0;  // of the frames since the coil was lost, those that were looked at
  int deferred_looks_ = 0;
  std::vector<Candidate> deferred_;  // seen in the last frame, not fitted yet
};

}  // namespace facenav::coil_tracking
