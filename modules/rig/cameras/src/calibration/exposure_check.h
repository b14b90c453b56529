#pragma once
// Checks the views before and during the fit of the rig. Wrong corners: one camera alone does not fit the
// view. Exposures not simultaneous: each camera alone fits the view, both together do not, because the board
// moved between them.

#include <functional>

#include "facenav/cameras/calibrate.h"

namespace facenav::cameras {

using ViewIndices = std::vector<std::size_t>;

struct TrustedViews {
  ViewIndices used;
  ViewIndices bad_left, bad_right;  // views whose corners do not fit one camera alone
  ViewIndices moved;                // views whose exposures were not simultaneous
  double alone_px = 0;              // median rms of the good views when each camera is fitted alone
};

/// Finds the trusted views. `solve`: fits the rig to some views. Views are left out while more than `fewest`
/// are used; of the last ones, those that still disagree are marked as moved.
TrustedViews trustedViews(const std::vector<BoardView>& views, const cv::Size& image_size, const Board& board,
                          std::size_t fewest, const std::function<StereoRig(const ViewIndices&)>& solve);

/// Motion of the board between both exposures of a view: rms over its corners, mm.
double movedBetween_mm(const StereoRig& rig, const BoardView& view, const Board& board);

/// Largest rms (px) of both images of a view together that agrees with cameras that fit it to `alone_px`
/// each.
double largestAgreeing_px(double alone_px);

}  // namespace facenav::cameras
