#include "known_lengths.h"

#include <cmath>

#include "rig_lengths.h"

namespace facenav::workflow {
namespace {

constexpr double kBetween_s = 0.1;  // a still pair counts as two frames: the tracker wants a marker at rest

}  // namespace

std::optional<LengthSeen> markerLength(const cameras::StereoRig& rig, const cameras::StereoFrame& pair,
                                       const coil_tracking::CoilModel& coil,
                                       coil_tracking::CoilTracker& tracker) {
  tracker.start(rig, coil);
  cameras::StereoFrame frame = pair;
  tracker.track(frame, {});
  frame.captured.s += kBetween_s;
  const auto seen = tracker.track(frame, {}).observation;
  if (!seen) return std::nullopt;
  LengthSeen length;
  length.ratio = lengthRatio(*seen, rig);
  length.sigma = std::hypot(seen->print_sigma_mm / seen->size_mm, seen->size_sigma_mm / seen->size_mm,
                            calibrationSigma(*seen, rig));
  Eigen::Vector3d middle_mm = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < 4; ++i)
    middle_mm += cameras::triangulate(rig, seen->left_px[i], seen->right_px[i]).mm / 4.0;
  length.at = Point<Camera>(middle_mm);
  if (!std::isfinite(length.ratio) || !(length.sigma > 0)) return std::nullopt;
  return length;
}

registration::CameraTurn turnBy(const LengthSeen& length, const registration::TurnableCamera& right) {
  const double ratio_by_rad = right.displacement(length.at.mm).norm() / length.at.mm.norm();
  const double sign = right.displacement(length.at.mm).dot(length.at.mm) > 0 ? 1.0 : -1.0;
  return {sign * (length.ratio - 1.0) / ratio_by_rad, length.sigma / ratio_by_rad};
}

}  // namespace facenav::workflow
