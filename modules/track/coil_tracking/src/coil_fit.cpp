#include "coil_fit.h"

#include <algorithm>
#include <cmath>

#include "facenav/core/robust_statistics.h"

namespace facenav::coil_tracking {
namespace {

// Acceptance limits of a fit.
constexpr double kLeastInlierFraction = 0.6;
constexpr double kMostRotationSigma_rad = 0.02, kMostTranslationSigma_mm = 1.5;
constexpr double kMostSizeSigma = 2.5e-3;  // with a larger error, the size does not constrain the depth
// One image allows two starting poses. The second is skipped if it is out of question, or leads to the same
// pose.
constexpr double kOutOfQuestion = 2.0;  // times the spread

bool isPlausible(const CoilSetup& setup, const MarkerFit& fit, const std::vector<std::size_t>& markers) {
  // An ARToolKit picture has a known outline only: blur and size look alike there, so yaw is not observable.
  const bool has_inner_edges = std::any_of(
      markers.begin(), markers.end(), [&](std::size_t marker) { return setup.patterns[marker].isBinary(); });
  if (has_inner_edges && fit.size_sigma > kMostSizeSigma) return false;
  const double rotation_variance = fit.covariance.diagonal().head<3>().maxCoeff();
  const double translation_variance = fit.covariance.diagonal().tail<3>().maxCoeff();
  const double shrink_px = std::max(std::abs(fit.shrink_px[0]), std::abs(fit.shrink_px[1]));
  return fit.bias_px <= kMostBias_px && fit.inlier_fraction >= kLeastInlierFraction &&
         shrink_px <= kSignificant * kShrinkSigma_px && fit.centre_mm.z() >= kLeastDepth_mm &&
         std::sqrt(rotation_variance) <= kMostRotationSigma_rad &&
         std::sqrt(translation_variance) <= kMostTranslationSigma_mm * fit.centre_mm.z() / 600.0;
}

std::vector<SeenMarker> seenOf(const CoilSetup& setup, const std::vector<std::size_t>& markers) {
  std::vector<SeenMarker> seen;
  for (const std::size_t marker : markers) seen.push_back(setup.seen(marker));
  return seen;
}

std::optional<CoilFit> finish(const CoilSetup& setup, const cameras::StereoFrame& frame,
                              const std::vector<std::size_t>& markers, const FitState& start,
                              FrameWork& work) {
  const auto fit = fitMarkers({setup.rig, frame, setup.motion}, seenOf(setup, markers), start, work);
  if (!fit || !isPlausible(setup, *fit, markers)) return std::nullopt;
  const Eigen::Isometry3d right_T_left = rightFromLeft(setup.rig, fit->free_state, fit->centre_mm);
  work.comparisons += 2 * kMatchComparisons * int(markers.size());
  for (const std::size_t marker : markers)
    if (!isReadInBoth(setup, frame, marker, fit->free_state.camera_T_coil, right_T_left)) return std::nullopt;
  return CoilFit{*fit, markers};
}

std::optional<CoilFit> fitFrom(const CoilSetup& setup, const cameras::StereoFrame& frame,
                               const std::vector<std::size_t>& markers, const FitStart& start,
                               FrameWork& work) {
  const auto rough = fitOutlines({setup.rig, frame, setup.motion}, seenOf(setup, markers), start, work);
  return rough ? finish(setup, frame, markers, rough->state, work) : std::nullopt;
}

/// Fits again with all other markers that both images show at their predicted places.
CoilFit withOtherMarkers(const CoilSetup& setup, const cameras::StereoFrame& frame, CoilFit found,
                         FrameWork& work) {
  std::vector<std::size_t> all = found.markers;
  const Eigen::Isometry3d right_T_left = rightFromLeft(setup.rig, found.fit.free_state, found.fit.centre_mm);
  for (const std::size_t marker : markersInView(setup, found.fit.camera_T_coil)) {
    if (std::find(all.begin(), all.end(), marker) != all.end()) continue;
    work.comparisons += 2 * kMatchComparisons;
    if (isReadInBoth(setup, frame, marker, found.fit.free_state.camera_T_coil, right_T_left))
      all.push_back(marker);
  }
  if (all.size() == found.markers.size()) return found;
  const auto together = fitFrom(setup, frame, all, {found.fit.free_state, 3}, work);
  return together ? *together : found;
}

bool isSame(const FitState& a, const FitState& b) {
  const Eigen::Isometry3d &at = a.camera_T_coil, &other = b.camera_T_coil;
  return (at.translation() - other.translation()).norm() < kMostTranslationSigma_mm &&
         rotationAngle(at.linear().transpose() * other.linear()) < kMostRotationSigma_rad;
}

}  // namespace

std::optional<CoilFit> fitCoil(const CoilSetup& setup, const cameras::StereoFrame& frame,
                               const std::vector<std::size_t>& markers, const CoilToCamera& start,
                               FrameWork& work) {
  FitState state;
  state.camera_T_coil = start.isometry();
  const auto found = fitFrom(setup, frame, markers, {state, searchReach_px(setup, markers, start)}, work);
  if (!found) return std::nullopt;
  return setup.patterns.size() == 1 ? *found : withOtherMarkers(setup, frame, *found, work);
}

std::optional<CoilFit> fitCoilFromEither(const CoilSetup& setup, const cameras::StereoFrame& frame,
                                         std::size_t marker, const std::vector<FitState>& starts,
                                         FrameWork& work) {
  std::vector<OutlineFit> rough;
  // A marker's size alone gives its depth to 2 %, which is an error of some pixels along the other image's
  // epipolar line.
  for (const FitState& start : starts) {
    const int reach_px = searchReach_px(setup, {marker}, CoilToCamera::fromIsometry(start.camera_T_coil));
    if (const auto fit =
            fitOutlines({setup.rig, frame, setup.motion}, seenOf(setup, {marker}), {start, reach_px}, work))
      rough.push_back(*fit);
  }
  std::sort(rough.begin(), rough.end(),
            [](const OutlineFit& a, const OutlineFit& b) { return a.spread < b.spread; });
  std::optional<CoilFit> best;
  for (const OutlineFit& fit : rough) {
    const OutlineFit& first = rough.front();
    if (best && (fit.spread > kOutOfQuestion * first.spread || isSame(fit.state, first.state))) continue;
    const auto found = finish(setup, frame, {marker}, fit.state, work);
    if (found && (!best || found->fit.bias_px < best->fit.bias_px)) best = found;
  }
  if (!best || setup.patterns.size() == 1) return best;
  return withOtherMarkers(setup, frame, *best, work);
}

}  // namespace facenav::coil_tracking
