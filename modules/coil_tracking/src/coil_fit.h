#pragma once
// CoilFit: from where the coil may be to a fit that passes as its marker. All printed edges in both images
// (marker_fit.h), and the pattern read in both where the fit puts it. Whether the cameras still stand as
// calibrated is asked apart.

#include <optional>
#include <vector>

#include "facenav/core/frame_work.h"
#include "marker_fit.h"
#include "marker_search.h"

namespace facenav::coil_tracking {

constexpr double kMostBias_px = 0.35;  // misfit of an edge's mean: a wrong pair, another object make more

struct CoilFit {
  MarkerFit fit;
  std::vector<std::size_t> markers;  // that were fitted, the most certain first
};

/// What the fit of one marker takes at most, about: found anew from one image, and from a prediction.
constexpr int kNewFitLooks = 1400, kFitLooks = 800;

/// These markers from about here, then with the others that both images show where the fit puts them.
std::optional<CoilFit> fitCoil(const CoilSetup& setup, const cameras::StereoFrame& frame,
                               const std::vector<std::size_t>& markers, const CoilToCamera& start,
                               FrameWork& work);
/// One marker from either of the poses that one image allows.
std::optional<CoilFit> fitCoilFromEither(const CoilSetup& setup, const cameras::StereoFrame& frame,
                                         std::size_t marker, const std::vector<CoilToCamera>& starts,
                                         FrameWork& work);

}  // namespace facenav::coil_tracking
