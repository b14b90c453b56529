#pragma once
// Averages several pictures of a face that does not move: less noise than in one picture, and so more points
// on smooth skin.

#include <deque>

#include "facenav/cameras/stereo_frame.h"

namespace facenav::steps {

/// Region of one camera's picture that is averaged, px.
struct SteadyRegion {
  cv::Rect face;
  cv::Rect kept;  // not averaged: the coil's marker, in a hand that may move on its own
};

struct SteadyMean {
  cameras::StereoFrame frame;
  int pictures = 1;  // number of pictures in the mean
};

/// Averages the `face` regions of the newest (last) frame with those of earlier frames in which neither
/// moved. A frame in which one moved is left out; if none is left, the newest is returned unchanged. 8-bit
/// pictures of one size. The pictures are copies.
SteadyMean steadyMean(const std::deque<cameras::StereoFrame>& frames, const SteadyRegion& left,
                      const SteadyRegion& right);

}  // namespace facenav::steps
