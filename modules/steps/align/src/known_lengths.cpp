#include "facenav/align/known_lengths.h"

#include <algorithm>
#include <cmath>

#include "facenav/health/rig_lengths.h"

namespace facenav::steps {
namespace {

constexpr double kBetween_s = 0.1;  // a still pair is added as two frames: the tracker needs a marker at rest
constexpr double kSameTime_s = 1e-3;
// Largest speed of a marker at rest. With a right picture 10 ms late, this speed changes the marker's depth
// by 0.06 mm, like a camera turn of 0.005 deg. The noise of a corner alone is 1 to 3 mm/s.
constexpr double kResting_mm_s = 6.0;
constexpr std::size_t kFewestFrames = 5;

std::optional<health::ScaleObservation> lengthOf(const health::SquareObservation& seen,
                                                 const cameras::StereoRig& rig) {
  health::ScaleObservation length;
  length.ratio = health::lengthRatio(seen, rig);
  length.sigma = std::hypot(seen.print_sigma_mm / seen.size_mm, seen.size_sigma_mm / seen.size_mm,
                            health::calibrationSigma(seen, rig));
  Eigen::Vector3d middle_mm = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < 4; ++i)
    middle_mm += cameras::triangulate(rig, seen.left_px[i], seen.right_px[i]).mm / 4.0;
  length.at = Point<Camera>(middle_mm);
  if (!std::isfinite(length.ratio) || !(length.sigma > 0)) return std::nullopt;
  return length;
}

}  // namespace

bool isOfOneMoment(const cameras::StereoFrame& pair) {
  return std::abs(pair.right_late_s.value_or(0.0)) <= kSameTime_s;
}

MarkerInPair markerInPair(const cameras::StereoRig& rig, const cameras::StereoFrame& pair,
                          const coil_tracking::CoilModel& coil, coil_tracking::CoilTracker& tracker) {
  if (!isOfOneMoment(pair)) return {};
  tracker.start(rig, coil);
  cameras::StereoFrame frame = pair;
  tracker.track(frame, {});
  frame.captured.s += kBetween_s;
  const auto found = tracker.track(frame, {});
  if (found.observation) return {lengthOf(*found.observation, rig)};
  return {std::nullopt, !found && found.reason() == LostReason::high_residual};
}

RestingMarker::RestingMarker(const cameras::StereoRig& rig, const coil_tracking::CoilModel& coil,
                             coil_tracking::CoilTracker& tracker)
    : rig_(rig), tracker_(tracker) {
  tracker_.start(rig_, coil);
}

/// Speed of the fastest corner.
double RestingMarker::speed_mm_s(const health::SquareObservation& now, double now_s) const {
  double moved_mm = 0;
  for (std::size_t i = 0; i < 4; ++i)
    moved_mm = std::max(moved_mm, (cameras::triangulate(rig_, now.left_px[i], now.right_px[i]).mm -
                                   cameras::triangulate(rig_, last_->left_px[i], last_->right_px[i]).mm)
                                      .norm());
  return moved_mm / std::max(1e-3, now_s - last_s_);
}

bool RestingMarker::add(const cameras::StereoFrame& frame) {
  const auto found = tracker_.track(frame, {});
  const auto& seen = found.observation;
  is_seen_ = found || seen;
  is_contradicted_ = !is_seen_ && found.reason() == LostReason::high_residual;
  const double now_s = frame.captured.s;
  const bool rests = seen && last_ && now_s > last_s_ && speed_mm_s(*seen, now_s) < kResting_mm_s;
  const auto length = rests ? lengthOf(*seen, rig_) : std::nullopt;
  if (!length) rests_since_s_.reset();
  if (length && !rests_since_s_) rests_since_s_ = last_s_;
  if (length) seen_.push_back(*length);
  last_ = seen;
  last_s_ = now_s;
  return length.has_value();
}

/// Computes the mean. The frames share the errors of print and calibration, so it is hardly more certain than
/// one of them.
std::optional<health::ScaleObservation> RestingMarker::length() const {
  if (seen_.size() < kFewestFrames) return std::nullopt;
  health::ScaleObservation mean;
  mean.ratio = 0.0;
  Eigen::Vector3d at_mm = Eigen::Vector3d::Zero();
  const double share = 1.0 / double(seen_.size());
  for (const auto& length : seen_) {
    mean.ratio += share * length.ratio;
    mean.sigma += share * length.sigma;
    at_mm += share * length.at.mm;
  }
  mean.at = Point<Camera>(at_mm);
  return mean;
}

std::optional<health::ScaleObservation> markerLengthIn(capture::FrameSource& film, std::int64_t first,
                                                       std::int64_t last,
                                                       const coil_tracking::CoilModel& coil,
                                                       coil_tracking::CoilTracker& tracker) {
  RestingMarker marker(film.rig(), coil, tracker);
  while (const auto frame = film.next()) {
    if (frame->number > last) break;
    if (frame->number >= first) marker.add(*frame);
  }
  return marker.length();
}

registration::CameraTurn turnBy(const health::ScaleObservation& length,
                                const registration::TurnableCamera& right) {
  const double ratio_by_rad = right.displacement(length.at.mm).norm() / length.at.mm.norm();
  const double sign = right.displacement(length.at.mm).dot(length.at.mm) > 0 ? 1.0 : -1.0;
  return {sign * (length.ratio - 1.0) / ratio_by_rad, length.sigma / ratio_by_rad};
}

}  // namespace facenav::steps
