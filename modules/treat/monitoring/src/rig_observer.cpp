#include "facenav/monitoring/rig_observer.h"

#include <algorithm>

#include "facenav/cameras/patch_match.h"
#include "facenav/health/rig_health.h"

namespace facenav::monitoring {
namespace {

constexpr std::size_t kFirstFeatures = 8, kLaterFeatures = 2;  // number of features matched in a frame

}  // namespace

health::RigObservation RigObserver::observe(const cameras::StereoFrame& frame,
                                            const Tracked<head_tracking::HeadPose>& head,
                                            const coil_tracking::CoilResult& coil) {
  const bool is_first = frames_++ < health::kFirstFrames;
  health::RigObservation seen;
  seen.captured = frame.captured;
  seen.square = coil.observation;
  if (coil)
    seen.square_fits = true;
  else if (coil.reason() == LostReason::camera && coil.observation)
    seen.square_fits = false;
  if (!head) return seen;
  seen.sees_face = true;
  seen.face_centre = head->face_centre;
  seen.right_camera = head->right_camera;
  if (head->features.empty() || head->between_exposures_mm >= kMostBetweenExposures_mm) return seen;
  const std::size_t most = std::min(head->features.size(), is_first ? kFirstFeatures : kLaterFeatures);
  for (std::size_t i = 0; i < most; ++i) {
    const auto& feature = head->features[next_feature_++ % head->features.size()];
    if (const auto match = cameras::matchPatch(frame.left, frame.right, feature.left_px, feature.right_px))
      seen.matches.push_back({feature.left_px, match->right_px, match->sigma_px});
  }
  next_feature_ += 7;  // other features in the next frame
  return seen;
}

}  // namespace facenav::monitoring
