#include "facenav/setup/coil_setup.h"

#include <algorithm>
#include <cmath>

#include "facenav/coil_tracking/coil_card.h"
#include "facenav/coil_tracking/visible_markers.h"
#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "facenav/geometry/rotation.h"

namespace facenav::steps {
namespace {

constexpr double kNewPose_rad = 2.0 * kRadPerDeg;  // smallest difference between two collected poses
constexpr std::size_t kFewestPoses = 24, kMostPoses = 150, kFewestJigs = 20;
constexpr double kGoodPivot_mm = 0.4;  // one standard deviation of the tip in the marker's frame
constexpr double kSlips_mm = 1.5;      // rms of a tip that moves from its place
constexpr double kStands_s = 4.0;      // time without a new pose after which the coil is not turned
constexpr double kLookEvery_s = 0.5;   // time between searches for other coils' markers

double sigma_mm(const coil_tracking::Pivot& pivot) { return std::sqrt(pivot.covariance.trace() / 3.0); }

std::vector<cv::Point2f> asPoints(const std::array<Eigen::Vector2d, 4>& corners) {
  std::vector<cv::Point2f> points;
  for (const auto& corner : corners) points.emplace_back(float(corner.x()), float(corner.y()));
  return points;
}

}  // namespace

CoilSetup::CoilSetup(const cameras::StereoRig& rig, const coil_tracking::CoilModel& coil,
                     MakeTracker make_tracker)
    : rig_(rig), coil_(coil), make_tracker_(std::move(make_tracker)), tracker_(make_tracker_()) {
  tracker_->start(rig_, coil_);
}

CoilSetup::~CoilSetup() = default;

void CoilSetup::startPivots() {
  stop();
  stage_ = Stage::centre;
  turned_s_ = now_s_;
}

void CoilSetup::startJig(const coil_tracking::CoilModel& jig) {
  stop();
  if (coil_tracking::shareMarker(jig, coil_)) {
    trouble_ = "the jig carries the same marker as the coil (" +
               coil_tracking::markerWords(coil_.markers.front()) + "): print another one for the jig";
    return;
  }
  jig_ = jig;
  jig_tracker_ = make_tracker_();
  jig_tracker_->start(rig_, jig);
  stage_ = Stage::jig;
}

void CoilSetup::startWave() {
  stop();
  tracker_->start(rig_, coil_);  // forgets what it learnt before the wave
  wave_.emplace(rig_);
  stage_ = Stage::wave;
}

void CoilSetup::stop() {
  poses_.clear();
  pivots_.clear();
  observations_.clear();
  jig_.reset();
  jig_tracker_.reset();
  is_jig_seen_ = false;
  trouble_.clear();
  result_.reset();
  stage_ = Stage::look;
}

void CoilSetup::add(const cameras::StereoFrame& frame) {
  now_s_ = frame.captured.s;
  const auto seen = tracker_->track(frame);
  is_seen_ = bool(seen);
  left_px_.clear();
  right_px_.clear();
  if (stage_ == Stage::jig) followJig(seen, frame);
  if (stage_ == Stage::wave) wave_->add(seen, now_s_);
  if (!seen) return lookForOthers(frame);
  other_marker_.reset();
  left_px_ = asPoints(seen->left_corners_px);
  right_px_ = asPoints(seen->right_corners_px);
  if (isPivoting()) take(seen->camera_T_marker);
}

void CoilSetup::followJig(const coil_tracking::CoilResult& coil, const cameras::StereoFrame& frame) {
  const auto jig = jig_tracker_->track(frame);
  is_jig_seen_ = bool(jig);
  if (coil && jig) observations_.push_back({coil->camera_T_marker, jig->camera_T_marker});
  if (observations_.size() >= kFewestJigs) tryJig();
}

bool CoilSetup::isOwn(int marker) const {
  const auto carries = [marker](const coil_tracking::CoilModel& coil) {
    return std::any_of(coil.markers.begin(), coil.markers.end(),
                       [marker](const auto& each) { return each.id == marker; });
  };
  return carries(coil_) || (jig_ && carries(*jig_));
}

void CoilSetup::lookForOthers(const cameras::StereoFrame& frame) {
  const auto& marker = coil_.markers.front();
  if (marker.pattern || (looked_for_others_s_ && now_s_ - *looked_for_others_s_ < kLookEvery_s)) return;
  looked_for_others_s_ = now_s_;
  other_marker_.reset();
  for (const int id : coil_tracking::visibleMarkers(frame.left, marker.dictionary))
    if (!isOwn(id)) other_marker_ = id;
}

void CoilSetup::take(const RigidTransform<Camera, Marker>& pose) {
  if (!poses_.empty() && rotationAngle(poses_.back().rotation().transpose() * pose.rotation()) < kNewPose_rad)
    return;
  poses_.push_back(pose);
  turned_s_ = now_s_;
  if (poses_.size() >= kFewestPoses && poses_.size() % 4 == 0) tryPivot();
}

void CoilSetup::tryPivot() {
  try {
    const auto pivot = coil_tracking::fitPivot(poses_);
    if (pivot.rms_mm > kSlips_mm) {
      trouble_ =
          formatted("the point slips by %.1f mm: keep it in its place on the tip while you turn the coil",
                    pivot.rms_mm);
    } else if (sigma_mm(pivot) > kGoodPivot_mm) {
      trouble_ = "turn the coil farther, the tip in its place";
    } else {
      pivots_.push_back(pivot);
      poses_.clear();
      trouble_.clear();
      stage_ = stage_ == Stage::centre ? Stage::handle : stage_ == Stage::handle ? Stage::side : Stage::done;
      if (stage_ == Stage::done) result_ = calibrateWithPivots(pivots_[0], pivots_[1], pivots_[2]);
    }
  } catch (const Error& error) {
    trouble_ = error.what();
    if (stage_ == Stage::done) {  // the three points do not fit together
      const std::string reason = trouble_;
      startPivots();
      trouble_ = reason;
    }
  }
  if (poses_.size() > kMostPoses) poses_.erase(poses_.begin(), poses_.begin() + kMostPoses / 2);
}

void CoilSetup::tryJig() {
  try {
    result_ = calibrateWithJig(observations_, jig_->markers.front().coil_T_marker);
    stage_ = Stage::done;
  } catch (const Error& error) {
    trouble_ = error.what();
    observations_.clear();
  }
}

double CoilSetup::progress() const {
  if (stage_ == Stage::done) return 1.0;
  if (stage_ == Stage::wave) return wave_->progress();
  if (stage_ == Stage::jig) return std::min(1.0, double(observations_.size()) / kFewestJigs);
  return std::min(1.0, double(poses_.size()) / kFewestPoses);
}

std::string CoilSetup::unseenWords() const {
  const std::string own = coil_tracking::markerWords(coil_.markers.front());
  if (other_marker_)
    return formatted(
        "this is another coil: its marker is %s id %d, not %s; take the right one, or choose this one",
        coil_.markers.front().dictionary.c_str(), *other_marker_, own.c_str());
  if (stage_ == Stage::jig && is_jig_seen_)
    return "the jig's marker is seen, the coil's (" + own + ") is not: turn both markers to the cameras";
  return "hold the coil so that both cameras see its marker (" + own + ")";
}

std::string CoilSetup::words() const {
  if (stage_ == Stage::wave && (!other_marker_ || wave_->isDone())) return wave_->words();
  if (!is_seen_ && stage_ != Stage::done) return unseenWords();
  if (isPivoting() && now_s_ - turned_s_ > kStands_s)
    return "the coil stands still: turn it by 30 degrees and more to all sides, its point on the tip";
  if (!trouble_.empty()) return trouble_;
  switch (stage_) {
    case Stage::look:
      return "the marker is recognised";
    case Stage::centre:
      return "stand the middle of the coil's face on a fixed tip, and turn the coil about it in all "
             "directions";
    case Stage::handle:
      return "now a point in the middle of the handle on the tip, and turn the coil";
    case Stage::side:
      return "now a point at the left of the face, seen from the handle, on the tip, and turn the coil";
    case Stage::jig:
      return is_jig_seen_ ? "both markers are seen: turn coil and jig a little, and hold them still"
                          : "the coil's marker is seen, the jig's (" +
                                coil_tracking::markerWords(jig_->markers.front()) +
                                ") is not: put the jig on the coil, its marker to both cameras";
    case Stage::wave:
      return wave_->words();
    case Stage::done:
      return formatted("the coil is calibrated: +-%.2f mm, +-%.2f deg", result_->sigma_mm,
                       result_->sigma_deg);
  }
  return {};
}

}  // namespace facenav::steps
