#include "coil_search.h"

#include <algorithm>
#include <utility>

namespace facenav::coil_tracking {
namespace {

constexpr int kOneLightComparisons = 600;  // approximate work to search one image in one light

/// True if this detection is the marker that `good` already fits.
bool explains(const CoilSetup& setup, const CoilFit& good, const MarkerDetection& seen, bool is_left) {
  const Eigen::Isometry3d right_T_left = rightFromLeft(setup.rig, good.fit.free_state, good.fit.centre_mm);
  const auto corners =
      cornersInImage(setup, seen.marker, good.fit.free_state.camera_T_coil, is_left, right_T_left);
  if (!corners) return false;
  const int reach_px = searchReach_px(setup, {seen.marker}, good.fit.camera_T_coil);
  for (int i = 0; i < 4; ++i)
    if (((*corners)[i] - seen.corners[i]).norm() > reach_px) return false;
  return true;
}

/// Start poses: those that the one image allows, and if the other contradicts them, those from both images.
std::vector<FitState> startsOf(const CoilSetup& setup, const MarkerDetection& seen, bool is_left,
                               const std::vector<MarkerDetection>& in_other) {
  const auto poses = posesFromOneImage(setup, seen, is_left);
  std::vector<FitState> starts;
  for (const auto& pose : poses) starts.emplace_back().camera_T_coil = pose.isometry();
  for (const auto& other : in_other) {
    if (other.marker != seen.marker) continue;
    const auto both = statesFromBothImages(setup, seen, is_left, other.corners, poses);
    starts.insert(starts.end(), both.begin(), both.end());
  }
  return starts;
}

/// Adds the fit; of two fits of one coil, keeps the one with the smaller bias. Two coils are farther apart
/// than half a marker.
void note(const CoilSetup& setup, const CoilFit& fit, std::size_t marker, std::vector<CoilFit>& good) {
  const double near_mm = 0.5 * setup.coil.markers[marker].size_mm;
  const auto same = std::find_if(good.begin(), good.end(), [&](const CoilFit& other) {
    return (other.fit.camera_T_coil.translation_mm() - fit.fit.camera_T_coil.translation_mm()).norm() <
               near_mm ||
           (other.fit.centre_mm - fit.fit.centre_mm).norm() < near_mm;
  });
  if (same == good.end())
    good.push_back(fit);
  else if (fit.fit.bias_px < same->fit.bias_px)
    *same = fit;
}

}  // namespace

CoilSearch::Found CoilSearch::seek(const CoilSetup& setup, const cameras::StereoFrame& frame,
                                   FrameWork& work) {
  Found found;
  deferred_comparisons_ = 0;
  if (!deferred_.empty()) {
    fit(setup, frame, std::exchange(deferred_, {}), found, work);
    if (!found.good.empty() || !deferred_.empty()) return found;
  }
  const bool is_left_first = turn_ % 2 == 0, is_fresh = turn_ == 0;
  std::vector<MarkerDetection> seen;  // in the image searched last
  for (const bool is_left : {is_left_first, !is_left_first}) {
    const bool is_seen = found.is_seen_in_left || found.is_seen_in_right;
    MarkerLight light = turn_ % 3 == 2 ? MarkerLight::dim : MarkerLight::bright;
    if ((is_fresh && is_left == is_left_first) || is_seen) light = MarkerLight::bright_else_dim;
    const int needed =
        light == MarkerLight::bright_else_dim ? 2 * kOneLightComparisons : kOneLightComparisons;
    if (work.left() < needed) {
      deferred_comparisons_ = needed + kNewFitComparisons;
      return found;
    }
    look(setup, frame, is_left, light, seen, found, work);
    if (!found.good.empty() || !deferred_.empty() || (seen.empty() && !is_fresh)) break;
  }
  ++turn_;
  return found;
}

void CoilSearch::look(const CoilSetup& setup, const cameras::StereoFrame& frame, bool is_left,
                      MarkerLight light, std::vector<MarkerDetection>& in_other, Found& found,
                      FrameWork& work) {
  auto seen = detectMarkers(is_left ? frame.left : frame.right, setup.patterns, light);
  work.comparisons += seen.comparisons;
  (is_left ? found.is_seen_in_left : found.is_seen_in_right) = !seen.markers.empty();
  std::vector<Candidate> candidates;
  for (const MarkerDetection& detection : seen.markers)
    candidates.push_back({detection, is_left, startsOf(setup, detection, is_left, in_other)});
  in_other = std::move(seen.markers);
  fit(setup, frame, std::move(candidates), found, work);
}

void CoilSearch::fit(const CoilSetup& setup, const cameras::StereoFrame& frame,
                     std::vector<Candidate> candidates, Found& found, FrameWork& work) {
  for (const Candidate& candidate : candidates) {
    const bool is_explained = std::any_of(found.good.begin(), found.good.end(), [&](const CoilFit& good) {
      return explains(setup, good, candidate.seen, candidate.is_left);
    });
    if (is_explained) continue;
    if (work.left() < kNewFitComparisons) {
      // It is not known which of the unfitted candidates is the coil.
      // Beside two fits the next frame has room for that of a tracked head.
      deferred_comparisons_ = std::min(int(candidates.size()), 2) * kNewFitComparisons;
      deferred_ = std::move(candidates);
      found.good.clear();
      return;
    }
    const auto fit = fitCoilFromEither(setup, frame, candidate.seen.marker, candidate.starts, work);
    if (fit) note(setup, *fit, candidate.seen.marker, found.good);
  }
}

}  // namespace facenav::coil_tracking
