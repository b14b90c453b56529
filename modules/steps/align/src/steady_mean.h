#pragma once
// The mean of several pictures of a face that does not move: less noise than in one of them, and so more
// points on smooth skin.

#include <deque>

#include "facenav/cameras/stereo_frame.h"

namespace facenav::steps {

/// Where one camera's picture is averaged, px.
struct SteadyRegion {
  cv::Rect face;
  cv::Rect kept;  // as in the newest picture: the coil's marker, in a hand that may move on its own
};

struct SteadyMean {
  cameras::StereoFrame frame;
  int pictures = 1;  // that it is the mean of
};

/// The newest (last) frame, its `face` regions averaged with those earlier frames in which neither moved. A
/// frame in which one did is left out; with none left, the newest is returned as it is. 8-bit pictures of one
/// size. The pictures are copies.
SteadyMean steadyMean(const std::deque<cameras::StereoFrame>& frames, const SteadyRegion& left,
                      const SteadyRegion& right);

}  // namespace facenav::steps
