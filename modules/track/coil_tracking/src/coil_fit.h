#pragma once
// CoilFit: an accepted fit of the coil, from an approximate pose. All printed edges in both images are fitted
// (marker_fit.h), and the pattern must be readable in both images at the fitted pose. Whether the calibration
// of the cameras still holds is checked separately.

#include <optional>
#include <vector>

#include "facenav/core/frame_work.h"
#include "marker_fit.h"
#include "marker_search.h"

namespace facenav::coil_tracking {

constexpr double kMostBias_px = 0.35;  // rms of edges' mean residuals; more: wrong pairing or another object

struct CoilFit {
  MarkerFit fit;
  std::vector<std::size_t> markers;  // fitted markers, the most certain first
};

/// Approximate upper limit of the work to fit one marker that was newly found, in patch comparisons.
constexpr int kNewFitComparisons = 1400;

/// Fits these markers near `start`, then adds the others that both images show at their predicted places.
std::optional<CoilFit> fitCoil(const CoilSetup& setup, const cameras::StereoFrame& frame,
                               const std::vector<std::size_t>& markers, const CoilToCamera& start,
                               FrameWork& work);
/// Fits one marker from the start that fits best, since one image allows two poses.
std::optional<CoilFit> fitCoilFromEither(const CoilSetup& setup, const cameras::StereoFrame& frame,
                                         std::size_t marker, const std::vector<FitState>& starts,
                                         FrameWork& work);

}  // namespace facenav::coil_tracking
