#include "facenav/health/rig_health.h"

#include "facenav/health/pair_diagnosis.h"
#include "facenav/health/surface_matches.h"
#include "rig_words.h"

namespace facenav::health {
namespace {

// If the reference pair's face fitted its calibration, a small contradiction by the skin does not prove that
// a camera moved: require twice the monitor's own threshold.
constexpr double kClearStatistic = 40;
constexpr std::size_t kFirstInterval = 5, kLaterInterval = 30;  // frames between judgements

}  // namespace

void RigHealth::start(const cameras::StereoFrame& pair, const PointCloud<Camera>& face,
                      const std::vector<Eigen::Vector2f>& left_px, const std::vector<cv::Point>& face_px) {
  const auto outline = face_px.empty() ? outlineOf(left_px) : face_px;
  monitor_.add(matchSurface(rig_, pair, face, left_px, outline));
  estimate_ = monitor_.estimate();
  const auto diagnosis = diagnosePair(rig_, pair, outline);
  if (diagnosis.isFault()) reference_fault_ = diagnosis.verdict();
  has_fitted_ = diagnosis.state == RigState::holds;
}

std::optional<RigVerdict> RigHealth::fault() const {
  if (reference_fault_) return reference_fault_;
  if (coil_contradicts_) return markerContradicts();
  if (const auto moved = drift_.fault()) return isCauseTold() ? *moved : placesDisagree();
  if (!estimate_.hasMoved()) return std::nullopt;
  const bool is_clear = estimate_.statistic > kClearStatistic;
  if (has_fitted_ && !is_clear) return std::nullopt;
  return isCauseTold() ? estimate_.verdict() : camerasDisagree(estimate_.epipolar_px);
}

/// True if a moved camera is told from pictures of two moments: the face of few frames may be off by one
/// motion of the head. A coil's square is seen only at rest.
bool RigHealth::isCauseTold() const { return has_seen_square_ || frames_ >= kFirstFrames; }

std::optional<CorrectedMotion> RigHealth::correction() const {
  return isCauseTold() ? drift_.correction() : std::nullopt;
}

void RigHealth::add(const RigObservation& seen) {
  if (seen.square) monitor_.add(*seen.square), has_seen_square_ = true;
  if (seen.square_fits == true) ++agreed_, contradicted_ = 0;
  if (seen.square_fits == false) ++contradicted_, agreed_ = 0;
  if (contradicted_ >= kFramesInARow) coil_contradicts_ = true;
  if (agreed_ >= kFramesInARow) coil_contradicts_ = false;
  if (!seen.matches.empty()) monitor_.add(seen.matches);
  seen.sees_face ? drift_.add(seen) : drift_.addWithoutFace(seen.captured);
  followDrift();
  const std::size_t interval = frames_ < kFirstFrames ? kFirstInterval : kLaterInterval;
  if (frames_++ % interval == 0) estimate_ = monitor_.estimate();
}

/// Restarts the monitor: its observations of the uncorrected cameras do not apply to the corrected ones.
void RigHealth::followDrift() {
  constexpr double kSame_rad = 0.01 * kRadPerDeg, kSame_mm = 0.1;
  if (!drift_.correction()) return;
  const Eigen::Isometry3d now = drift_.right_T_left().isometry(),
                          step = now * rig_.right_T_left.isometry().inverse();
  if (rotationAngle(step.linear()) < kSame_rad && step.translation().norm() < kSame_mm) return;
  rig_.right_T_left = drift_.right_T_left();
  monitor_ = RigMonitor(rig_);
  estimate_ = {};
}

}  // namespace facenav::health
