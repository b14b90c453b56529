#pragma once
// The views of one calibration, and the fit of a rig to some of them.

#include <vector>

#include "board_pose.h"
#include "exposure_check.h"

namespace facenav::cameras {

struct BoardViews {
  const std::vector<BoardView>& views;
  cv::Size size;
  Board board;
};

std::vector<ViewFit> fitViews(const BoardViews& task, const StereoRig& rig, const ViewIndices& indices);

/// Rms over all fits, px.
double rmsOf(const std::vector<ViewFit>& fits);

}  // namespace facenav::cameras
