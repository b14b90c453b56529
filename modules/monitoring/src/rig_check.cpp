#include "facenav/monitoring/rig_check.h"

#include <algorithm>

#include "facenav/cameras/patch_match.h"

namespace facenav::monitoring {
namespace {

constexpr std::size_t kFirstFrames = 30;  // in which the session's start is judged
constexpr std::size_t kFirstFeatures = 8, kLaterFeatures = 2;
// Above it, head motion would look like a rotation of the camera.
constexpr double kMostBetweenExposures_mm = 0.1;
// If the whole reference pair fitted its calibration, skin that disagrees a little does not prove that a
// camera moved: require twice the monitor's own threshold.
constexpr double kClearStatistic = 40, kClearContradiction = 2.0;
constexpr std::size_t kFirstInterval = 5, kLaterInterval = 30;  // frames between verdicts
/// Frames in a row of the coil that change the verdict: one frame may be a hand over the marker's edge.
constexpr std::size_t kCoilFrames = 5;

cameras::SquareObservation square(const coil_tracking::MarkerObservation& marker) {
  return {marker.left_px, marker.right_px, marker.size_mm, marker.print_sigma_mm, marker.size_sigma_mm};
}

}  // namespace

std::vector<cameras::Correspondence> matchSurface(const cameras::StereoRig& rig,
                                                  const cameras::StereoFrame& frame,
                                                  const PointCloud<Camera>& surface,
                                                  const std::vector<Eigen::Vector2f>& left_px,
                                                  std::size_t most) {
  std::vector<cameras::Correspondence> found;
  const std::size_t count = std::min(surface.points_mm.size(), left_px.size());
  const std::size_t tries = 4 * most, step = std::max<std::size_t>(1, count / tries);
  for (std::size_t i = step / 2; i < count && found.size() < most; i += step) {
    const Eigen::Vector3d in_right_mm = rig.right_T_left.isometry() * surface.points_mm[i];
    if (in_right_mm.z() <= 0) continue;
    const Eigen::Vector2d left = left_px[i].cast<double>();
    if (const auto match =
            cameras::matchPatch(frame.left, frame.right, left, cameras::project(rig.right, in_right_mm)))
      found.push_back({left, match->right_px, match->sigma_px});
  }
  return found;
}

void RigCheck::start(const head_tracking::HeadReference& reference) {
  monitor_.add(matchSurface(rig_, reference.frame, reference.surface, reference.surface_left_px));
  verdict_ = monitor_.verdict();
  const auto diagnosis = cameras::diagnosePair(rig_, reference.frame);
  reference_fault_ = rigFault(diagnosis);
  has_fitted_ = diagnosis.fault == cameras::PairFault::none;
}

std::optional<RigFault> RigCheck::fault() const {
  if (reference_fault_) return reference_fault_;
  if (coil_contradicts_)
    return RigFault{head_tracking::LossDetail::cameras_moved,
                    "the coil's marker is not measured at its printed size: a camera has turned since the "
                    "calibration, or coil.json names another size: measure the print, or calibrate again"};
  if (const auto moved = drift_.fault()) return moved;
  if (!verdict_.hasMoved()) return std::nullopt;
  const bool is_clear = verdict_.statistic > kClearStatistic || verdict_.contradiction > kClearContradiction;
  if (has_fitted_ && !is_clear) return std::nullopt;
  return RigFault{head_tracking::LossDetail::cameras_moved, verdict_.words()};
}

void RigCheck::add(const cameras::StereoFrame& frame, const Tracked<head_tracking::HeadPose>& head,
                   const coil_tracking::CoilResult& coil) {
  const bool is_first = frames_ < kFirstFrames;
  if (coil.observation) monitor_.add(square(*coil.observation));
  const bool contradicts = !coil && coil.reason() == LostReason::camera && coil.observation;
  if (coil) ++agreed_, contradicted_ = 0;
  if (contradicts) ++contradicted_, agreed_ = 0;
  if (contradicted_ >= kCoilFrames) coil_contradicts_ = true;
  if (agreed_ >= kCoilFrames) coil_contradicts_ = false;
  if (head && !head->features.empty() && head->between_exposures_mm < kMostBetweenExposures_mm) {
    std::vector<cameras::Correspondence> points;
    const std::size_t most = std::min(head->features.size(), is_first ? kFirstFeatures : kLaterFeatures);
    for (std::size_t i = 0; i < most; ++i) {
      const auto& feature = head->features[next_feature_++ % head->features.size()];
      if (const auto match = cameras::matchPatch(frame.left, frame.right, feature.left_px, feature.right_px))
        points.push_back({feature.left_px, match->right_px, match->sigma_px});
    }
    next_feature_ += 7;  // other features next time
    monitor_.add(points);
  }
  head ? drift_.add(frame.captured, *head) : drift_.addWithoutFace(frame.captured);
  followDrift();
  if (frames_++ % (is_first ? kFirstInterval : kLaterInterval) == 0) verdict_ = monitor_.verdict();
}

/// What the monitor gathered with the cameras as they stood before says nothing about the corrected ones.
void RigCheck::followDrift() {
  constexpr double kSame_rad = 0.01 * kRadPerDeg, kSame_mm = 0.1;
  if (!drift_.isCorrected()) return;
  const Eigen::Isometry3d now = drift_.right_T_left().isometry(),
                          step = now * rig_.right_T_left.isometry().inverse();
  if (rotationAngle(step.linear()) < kSame_rad && step.translation().norm() < kSame_mm) return;
  rig_.right_T_left = drift_.right_T_left();
  monitor_ = cameras::RigMonitor(rig_);
  verdict_ = {};
}

}  // namespace facenav::monitoring
