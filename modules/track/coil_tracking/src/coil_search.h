#pragma once
// CoilSearch: finds a lost coil anywhere in the frame, with limited work per frame. While the coil stays
// lost, a frame searches one image, left and right in turn, and the other image only if the first shows a
// marker. This halves the work and finds the coil at most one frame later. Every third such frame searches
// for dim light, so six frames cover each image in both lights. Work beyond the budget is deferred to the
// next frame and its images.

#include <vector>

#include "coil_fit.h"
#include "marker_detection.h"

namespace facenav::coil_tracking {

class CoilSearch {
 public:
  struct Found {
    std::vector<CoilFit> good;  // fits at different places
    bool is_seen_in_left = false, is_seen_in_right = false;
    bool isSeen() const { return (is_seen_in_left && is_seen_in_right) || !good.empty(); }
  };

  /// Searches in a frame in which the coil was not found at its predicted pose. Adds to `work`.
  Found seek(const CoilSetup& setup, const cameras::StereoFrame& frame, FrameWork& work);
  /// Resets the search, because the coil was found or the frame is unusable.
  void end() { *this = {}; }
  /// Work needed to continue in the next frame.
  FrameWork deferred() const { return {deferred_comparisons_}; }

 private:
  /// A marker detected in one image, and start poses for its fit.
  struct Candidate {
    MarkerDetection seen;
    bool is_left;
    std::vector<FitState> starts;
  };

  /// Searches one image. `in_other`: markers in the other image, empty before it is searched; replaced by
  /// those of this image.
  void look(const CoilSetup& setup, const cameras::StereoFrame& frame, bool is_left, MarkerLight light,
            std::vector<MarkerDetection>& in_other, Found& found, FrameWork& work);
  /// Fits all candidates, or defers all of them.
  void fit(const CoilSetup& setup, const cameras::StereoFrame& frame, std::vector<Candidate> candidates,
           Found& found, FrameWork& work);

  int turn_ = 0;  // frames searched since the coil was lost
  int deferred_comparisons_ = 0;
  std::vector<Candidate> deferred_;  // detected in the last frame, not fitted yet
};

}  // namespace facenav::coil_tracking
