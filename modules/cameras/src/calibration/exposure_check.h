#pragma once
// Which views can be believed, before and beside the rig: a view may have wrong corners (one camera alone
// does not fit it), or its two exposures were not taken at the same time (each camera alone fits it, both
// together do not: the board moved in between).

#include <functional>

#include "facenav/cameras/calibrate.h"

namespace facenav::cameras {

using ViewIndices = std::vector<std::size_t>;

struct TrustedViews {
  ViewIndices used;
  ViewIndices bad_left, bad_right;  // corners that one camera alone does not fit
  ViewIndices moved;                // not simultaneous
  double alone_px = 0;              // median rms of the good views where each camera is fitted alone
};

/// `solve`: the rig of these views. Never leaves fewer than `fewest` views: the last ones are kept even where
/// they disagree.
TrustedViews trustedViews(const std::vector<BoardView>& views, const cv::Size& image_size, const Board& board,
                          std::size_t fewest, const std::function<StereoRig(const ViewIndices&)>& solve);

/// How far the board moved between both exposures of a view: rms over its corners, mm.
double movedBetween_mm(const StereoRig& rig, const BoardView& view, const Board& board);

/// Both sides of a view together, px, above which it disagrees with cameras that fit it to `alone_px` each.
double largestAgreeing_px(double alone_px);

}  // namespace facenav::cameras
