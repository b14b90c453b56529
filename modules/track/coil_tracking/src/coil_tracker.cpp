#include "facenav/coil_tracking/coil_tracker.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "coil_fit.h"
#include "coil_search.h"
#include "coil_surroundings.h"
#include "edge_filter.h"
#include "facenav/core/robust_statistics.h"
#include "facenav/geometry/rigid_fit.h"
#include "facenav/health/rig_monitor.h"
#include "row_time_estimate.h"

namespace facenav::coil_tracking {
namespace {

// Limits within which the calibration still holds. Pitch moves the image across the epipolar lines, roll
// turns it; calibrations leave 0.1-0.3 px and 0.02 deg. Yaw changes only the apparent size of the print, so a
// wrong size means a wrong depth.
constexpr double kMostPitch_px = 0.6, kMostRoll_rad = 2.6e-3;
constexpr double kScaleSigma = 1e-3;        // relative error of lengths after a good calibration
constexpr double kMostDepthError_mm = 2.5;  // half of a harmful error; the size shows it reliably
constexpr double kLongestPrediction_s = 0.5;
constexpr double kSteady_s = 0.03;  // time constant that smooths rotation and receding speed
// Largest speed at which a marker is used to check the cameras: the two may expose some milliseconds apart.
constexpr double kResting_mm_s = 15.0;

bool isUsable(const cv::Mat& grey, const cameras::StereoRig& rig) {
  return grey.type() == CV_8UC1 && grey.cols == rig.width_px && grey.rows == rig.height_px;
}

/// True for uniform grey: lens covered, camera unplugged, or black.
bool isBlank(const cv::Mat& grey) {
  double low = 0, high = 0;
  cv::minMaxLoc(grey, &low, &high);
  return high - low < 10.0;
}

class MarkerCoilTracker final : public CoilTracker {
 public:
  void start(const cameras::StereoRig& rig, const CoilModel& coil) override;
  CoilResult track(const cameras::StereoFrame& frame, const CoilContext& context) override;

 private:
  Tracked<CoilPose> poseIn(const cameras::StereoFrame& frame);
  std::optional<CoilFit> fitPredicted(const cameras::StereoFrame& frame, const CoilToCamera& prediction);
  /// True if the velocity is known well enough for the exposure offset. It is unknown for a coil just found.
  bool isMotionKnown() const;
  bool holdsCalibration(const CoilFit& solution) const;
  Eigen::Isometry3d rightFromLeftAsSeen(const MarkerFit& fit) const {
    return rightFromLeft(setup_.rig, fit.free_state, fit.centre_mm);
  }
  std::optional<CoilToCamera> predicted(double t_s) const;
  /// The right camera's pose relative to a coil at rest: moved by the coil's motion between the exposures.
  RigidTransform<RightCamera, Camera> rightAsSeen(const std::optional<CoilToCamera>& prediction) const;
  void remember(const CoilFit& solution, double t_s);
  /// The longest time between the coil's rows and the moment of the pose, in either camera, s.
  double lag_s(const CoilFit& solution) const;
  /// Fits again if this frame changed the velocity that the fit `assumed`, and with it the motion correction.
  CoilFit asItMoves(const cameras::StereoFrame& frame, const CoilFit& found, const Vector6d& assumed);
  void forgetMotion() { velocity_.setZero(), turning_.setZero(), receding_mm_s_ = 0.0, across_.reset(); }
  bool isMoving() const { return velocity_.tail<3>().norm() >= kResting_mm_s; }
  Tracked<CoilPose> accept(const CoilFit& solution);
  health::SquareObservation observationOf(const CoilFit& solution) const;
  /// Covariance of a pose at the observed corners due to the calibration's uncertainty.
  Matrix6d calibrationCovariance() const;

  CoilSetup setup_;  // its rig includes the coil's motion between the exposures
  RigidTransform<RightCamera, Camera> right_T_left_;
  double right_late_s_ = 0.0, right_late_sigma_s_ = 0.0, right_turn_sigma_rad_ = 0.0;
  Vector6d velocity_ = Vector6d::Zero();  // (rad/s, mm/s), Camera, of the coil's origin
  // Parts of the velocity. `across_` needs the left image only and is used as measured. The others depend on
  // the correction for motion itself, so they are smoothed: their errors would feed back.
  std::optional<Eigen::Vector3d> across_;  // mm/s, of the left camera's ray, between the last two frames
  Eigen::Vector3d turning_ = Eigen::Vector3d::Zero();  // rad/s
  double receding_mm_s_ = 0.0;                         // along that ray's z
  struct Past {
    CoilToCamera camera_T_coil;
    double t_s;
  };
  std::optional<Past> last_, before_;
  CoilSurroundings surroundings_;  // in the last pictures
  RowTimeEstimate row_times_;
  std::vector<std::size_t> last_markers_;
  CoilSearch search_;
  FrameWork work_;  // of the frame so far, including the head's
  std::optional<health::SquareObservation> observation_;
  cameras::RigUncertainty uncertainty_;
};

void MarkerCoilTracker::start(const cameras::StereoRig& rig, const CoilModel& coil) {
  if (coil.markers.empty()) throw Error("the coil has no marker", {}, "give one in coil.json");
  setup_ = {rig, coil, {}, {}};
  right_T_left_ = rig.right_T_left;
  right_late_s_ = right_late_sigma_s_ = right_turn_sigma_rad_ = 0.0, forgetMotion();
  for (const MarkerModel& marker : coil.markers) setup_.patterns.push_back(MarkerPattern::load(marker));
  uncertainty_ = cameras::uncertaintyOf(rig);
  edgeWeights(kMostTaps, 0.8);  // builds the table at start, not during a frame
  last_.reset();
  before_.reset();
  surroundings_ = {};
  row_times_.start(rig);
  observation_.reset();
  search_.end();
  work_ = {};
}

CoilResult MarkerCoilTracker::track(const cameras::StereoFrame& frame, const CoilContext& context) {
  FACENAV_EXPECT(!setup_.patterns.empty(), "track() before start()");
  if (context.right_T_left) right_T_left_ = *context.right_T_left;
  right_turn_sigma_rad_ = context.right_turn_sigma_rad;
  right_late_s_ = context.exposure_offset.right_late_s;
  right_late_sigma_s_ = context.exposure_offset.sigma_s;
  work_ = context.work_before;
  CoilResult result = poseIn(frame);
  result.work = work_;
  result.deferred = search_.deferred();
  result.row_times_s = {setup_.rig.left.row_time_s, setup_.rig.right.row_time_s};
  if (before_ && !isMoving()) result.observation = observation_;
  return result;
}

Tracked<CoilPose> MarkerCoilTracker::poseIn(const cameras::StereoFrame& frame) {
  observation_.reset();
  const double t_s = frame.captured.s;
  const auto prediction = predicted(t_s);
  setup_.rig.right_T_left = rightAsSeen(prediction);
  setup_.motion.velocity = velocity_;
  std::optional<CoilFit> found;
  bool is_seen = false;
  if (!isUsable(frame.left, setup_.rig) || !isUsable(frame.right, setup_.rig)) {
    last_.reset();
    search_.end();
    return Lost{LostReason::camera};
  }
  if (prediction && isMoving() && surroundings_.isRepeatedIn(frame)) return Lost{LostReason::stale};
  if (prediction) found = fitPredicted(frame, *prediction);
  if (!found) {
    const CoilSearch::Found places = search_.seek(setup_, frame, work_);
    is_seen = places.isSeen();
    if (places.good.size() == 1) found = places.good.front();
  }
  if (found) {
    search_.end();
    const Vector6d assumed = velocity_;
    remember(*found, t_s);
    found = asItMoves(frame, *found, assumed);
    observation_ = observationOf(*found);
    surroundings_ = {frame, *observation_};
    if (isMoving() && across_) row_times_.add(found->fit.row_times, setup_.rig);
    row_times_.applyTo(setup_.rig);
    if (isMotionKnown() && holdsCalibration(*found)) return accept(*found);
    return Lost{LostReason::camera};
  }
  last_.reset();
  before_.reset();
  forgetMotion();
  if (is_seen) return Lost{LostReason::high_residual};  // nothing fits, or the marker is visible twice
  return Lost{isBlank(frame.left) || isBlank(frame.right) ? LostReason::camera : LostReason::no_marker};
}

RigidTransform<RightCamera, Camera> MarkerCoilTracker::rightAsSeen(
    const std::optional<CoilToCamera>& prediction) const {
  if (!prediction || !before_ || right_late_s_ == 0.0) return right_T_left_;
  const Eigen::Vector3d origin_mm = prediction->translation_mm();
  const Eigen::Vector3d by_mm = right_late_s_ * velocity_.tail<3>();
  Eigen::Isometry3d moved = Eigen::Isometry3d::Identity();
  moved.linear() = expRotation(right_late_s_ * velocity_.head<3>());
  moved.translation() = origin_mm + by_mm - moved.linear() * origin_mm;
  return RigidTransform<RightCamera, Camera>::fromIsometry(right_T_left_.isometry() * moved);
}

/// Also used for a rejected fit: motion between the exposures may be the reason.
void MarkerCoilTracker::remember(const CoilFit& solution, double t_s) {
  before_ = last_;
  last_ = Past{solution.fit.camera_T_coil, t_s};
  last_markers_ = solution.markers;
  const double since_s = before_ ? last_->t_s - before_->t_s : 0.0;
  if (since_s < 1e-4 || since_s > kLongestPrediction_s) {
    forgetMotion();
    return;
  }
  const Eigen::Isometry3d &now = last_->camera_T_coil.isometry(), &then = before_->camera_T_coil.isometry();
  const double smooth = 1.0 - std::exp(-since_s / kSteady_s);
  turning_ += smooth * (logRotation(now.linear() * then.linear().transpose()) / since_s - turning_);
  receding_mm_s_ += smooth * ((now.translation().z() - then.translation().z()) / since_s - receding_mm_s_);
  const Eigen::Vector3d ray = now.translation() / now.translation().z();
  const Eigen::Vector3d across =
      now.translation().z() * (ray - then.translation() / then.translation().z()) / since_s;
  // `across` is the mean between two frames; half of its change extrapolates it to the present.
  const Eigen::Vector3d present = across_ ? Eigen::Vector3d(across + 0.5 * (across - *across_)) : across;
  across_ = across;
  velocity_ << turning_, present + receding_mm_s_ * ray;
}

CoilFit MarkerCoilTracker::asItMoves(const cameras::StereoFrame& frame, const CoilFit& found,
                                     const Vector6d& assumed) {
  const double sigma_mm = std::sqrt(found.fit.covariance.diagonal().tail<3>().minCoeff());
  if (lag_s(found) * (velocity_ - assumed).tail<3>().norm() < sigma_mm) return found;  // within its error
  setup_.rig.right_T_left = rightAsSeen(found.fit.camera_T_coil);
  setup_.motion.velocity = velocity_;
  const auto again = fitCoil(setup_, frame, found.markers, found.fit.camera_T_coil, work_);
  if (!again) return found;
  last_->camera_T_coil = again->fit.camera_T_coil;
  return *again;
}

double MarkerCoilTracker::lag_s(const CoilFit& solution) const {
  const Eigen::Vector3d& left_mm = solution.fit.centre_mm;
  const Eigen::Vector3d right_mm = setup_.rig.right_T_left.isometry() * left_mm;
  const double middle_row = 0.5 * (setup_.rig.height_px - 1);
  const auto late_s = [&](const cameras::CameraModel& camera, const Eigen::Vector3d& p_mm) {
    return camera.row_time_s * (cameras::project(camera, p_mm).y() - middle_row);
  };
  return std::max(std::abs(late_s(setup_.rig.left, left_mm)),
                  std::abs(right_late_s_ + late_s(setup_.rig.right, right_mm)));
}

std::optional<CoilToCamera> MarkerCoilTracker::predicted(double t_s) const {
  if (!last_) return std::nullopt;
  const double since_s = t_s - last_->t_s;
  if (since_s < 0 || since_s > kLongestPrediction_s) return std::nullopt;
  if (!before_ || last_->t_s - before_->t_s < 1e-4) return last_->camera_T_coil;
  const double factor = std::min(2.0, since_s / (last_->t_s - before_->t_s));
  const Eigen::Isometry3d& now = last_->camera_T_coil.isometry();
  const Eigen::Isometry3d& then = before_->camera_T_coil.isometry();
  Eigen::Isometry3d next = now;
  next.linear() = expRotation(factor * logRotation(now.linear() * then.linear().transpose())) * now.linear();
  next.translation() += factor * (now.translation() - then.translation());
  return CoilToCamera::fromIsometry(next);
}

std::optional<CoilFit> MarkerCoilTracker::fitPredicted(const cameras::StereoFrame& frame,
                                                       const CoilToCamera& prediction) {
  const auto in_view = markersInView(setup_, prediction);
  if (in_view.empty()) return std::nullopt;
  std::vector<std::size_t> expected;  // markers found in the last frame
  for (const std::size_t marker : in_view)
    if (std::find(last_markers_.begin(), last_markers_.end(), marker) != last_markers_.end())
      expected.push_back(marker);
  if (!expected.empty())
    if (auto fit = fitCoil(setup_, frame, expected, prediction, work_)) return fit;
  if (in_view.size() == 1 && !expected.empty()) return std::nullopt;
  for (const std::size_t marker : in_view) {
    if (work_.left() < kNewFitComparisons) break;
    if (auto fit = fitCoil(setup_, frame, {marker}, prediction, work_)) return fit;
  }
  return std::nullopt;
}

/// Motion along the baseline between the two exposures looks like depth.
bool MarkerCoilTracker::isMotionKnown() const {
  if (right_late_s_ == 0.0) return true;
  if (!before_) return false;
  const Eigen::Vector3d baseline_mm =
      right_T_left_.isometry().linear().transpose() * right_T_left_.isometry().translation();
  const double along_mm_s = std::abs(velocity_.tail<3>().dot(baseline_mm.normalized()));
  const double depth_by_motion = last_->camera_T_coil.translation_mm().z() / baseline_mm.norm();
  return along_mm_s * kSignificant * right_late_sigma_s_ * depth_by_motion < kMostDepthError_mm;
}

bool MarkerCoilTracker::holdsCalibration(const CoilFit& solution) const {
  const MarkerFit& fit = solution.fit;
  const double focal_px = setup_.rig.right.k(1, 1), pitch_px = std::abs(fit.pitch_rad) * focal_px;
  if (pitch_px > kMostPitch_px + 3 * focal_px * right_turn_sigma_rad_ ||
      std::abs(fit.roll_rad) > kMostRoll_rad + 3 * std::hypot(fit.roll_sigma_rad, right_turn_sigma_rad_))
    return false;
  double print_sigma = 1.0;  // size factor's standard error, the smallest of the prints
  for (const std::size_t marker : solution.markers)
    print_sigma = std::min(print_sigma,
                           setup_.coil.markers[marker].size_sigma_mm / setup_.coil.markers[marker].size_mm);
  const double sigma =
      std::sqrt(print_sigma * print_sigma + fit.size_sigma * fit.size_sigma + kScaleSigma * kScaleSigma);
  const double harmful = kMostDepthError_mm / fit.centre_mm.z();
  return std::abs(fit.size_factor - 1.0) <= std::min(3 * sigma, std::max(2 * sigma, harmful));
}

health::SquareObservation MarkerCoilTracker::observationOf(const CoilFit& solution) const {
  const MarkerFit& fit = solution.fit;
  const std::size_t marker = solution.markers.front();
  CoilSetup sized = setup_;
  sized.coil.markers[marker].size_mm *= fit.free_state.size_factor;
  sized.rig.right_T_left = right_T_left_;  // for simultaneous exposures
  const Eigen::Isometry3d right_T_left = rightFromLeft(sized.rig, fit.free_state, fit.centre_mm);
  health::SquareObservation observation;
  observation.left_px.fill(Eigen::Vector2d::Zero()), observation.right_px.fill(Eigen::Vector2d::Zero());
  const auto left = cornersInImage(sized, marker, fit.free_state.camera_T_coil, true, right_T_left);
  const auto right = cornersInImage(sized, marker, fit.free_state.camera_T_coil, false, right_T_left);
  if (left) observation.left_px = *left;
  if (right) observation.right_px = *right;
  observation.sigma_px = fit.pitch_sigma_rad * setup_.rig.right.k(1, 1);
  observation.size_mm = setup_.coil.markers[marker].size_mm;
  observation.print_sigma_mm = setup_.coil.markers[marker].size_sigma_mm;
  observation.size_sigma_mm = fit.size_sigma * observation.size_mm;
  return observation;
}

Matrix6d MarkerCoilTracker::calibrationCovariance() const {
  Matrix6d covariance = Matrix6d::Zero();
  const auto corners = [&](const cameras::StereoRig& rig) {
    std::vector<Eigen::Vector3d> points_mm;
    for (int i = 0; i < 4; ++i)
      points_mm.push_back(cameras::triangulate(rig, observation_->left_px[i], observation_->right_px[i]).mm);
    return points_mm;
  };
  const auto nominal_mm = corners(setup_.rig);
  const Eigen::Vector3d centre_mm = 0.25 * (nominal_mm[0] + nominal_mm[1] + nominal_mm[2] + nominal_mm[3]);
  for (const cameras::StereoRig& rig : uncertainty_.one_sigma) {
    const Eigen::Isometry3d motion = fitRigidPoints(nominal_mm, corners(rig)).to_T_from;
    Vector6d change;
    change << logRotation(motion.linear()), motion * centre_mm - centre_mm;
    if (change.allFinite()) covariance += change * change.transpose();
  }
  return covariance;
}

Tracked<CoilPose> MarkerCoilTracker::accept(const CoilFit& solution) {
  CoilPose pose;
  pose.camera_T_marker = solution.fit.camera_T_coil * setup_.coil.markers.front().coil_T_marker;
  pose.covariance = solution.fit.covariance + calibrationCovariance();
  pose.left_corners_px = observation_->left_px;
  pose.right_corners_px = observation_->right_px;
  const double fit_quality = 1.0 - solution.fit.bias_px / kMostBias_px;
  return {pose, std::clamp(fit_quality * solution.fit.inlier_fraction, 0.0, 1.0)};
}

}  // namespace

std::unique_ptr<CoilTracker> makeMarkerCoilTracker() { return std::make_unique<MarkerCoilTracker>(); }

}  // namespace facenav::coil_tracking
