#include "face_recovery.h"

#include <algorithm>
#include <limits>

namespace facenav::head_tracking {
namespace {

constexpr std::size_t kMostRemembered = 6;  // each costs one more fit if the reference is not enough
constexpr double kTurn_mm = 200.0;          // distance equivalent to one radian: 3.5 mm a degree

// Squared Mahalanobis distance between the poses of each camera alone, above which the images are out of
// step, unless the skin lies on its epipolar lines: an expression that the reference does not know moves the
// two poses apart, too. Higher accepts more pairs of two moments.
constexpr double kApart = 35.0;
constexpr double kUneven = 0.5;      // ratio of the two cameras' shares of windows in place
constexpr double kSideFound = 0.35;  // least share of windows in place for the patient's face

}  // namespace

FaceRecovery::FaceRecovery(const cameras::StereoRig& rig, const cameras::StereoFrame& reference,
                           const FaceRegion& region, const FaceSurface& surface,
                           const std::optional<face::StereoFace>& face,
                           std::shared_ptr<const face::FaceDetector> detector)
    : rig_(rig), detector_(std::move(detector)) {
  const SkinMobility mobility = face ? SkinMobility(face->left) : SkinMobility();
  points_ = SkinPoints(rig, reference, region, surface, mobility);
  shape_ = FaceShape(rig, region, surface, mobility);
  if (face) landmarks_mm_ = face->points_mm, roll_rad_ = face->left.roll_rad;
  reference_ = std::make_shared<SkinView>(points_.reference());
}

SidesVerdict FaceRecovery::sidesOf(const RecoveredFace& found) const {
  const auto& share = found.identity.side_share;
  const bool is_even = std::min(share[0], share[1]) > kUneven * std::max(share[0], share[1]);
  if (is_even) {
    // A small face may be too little for a pose in each image alone.
    const bool is_apart = found.pose.sides_apart && *found.pose.sides_apart > kApart;
    return is_apart && !found.lines.isClean() ? SidesVerdict::out_of_step : SidesVerdict::agree;
  }
  for (const std::size_t c : {0u, 1u}) {  // does each image show the face at some pose?
    const RecoveryPose own = fitRecoveryPose(rig_, points_, *found.then, *found.pictures,
                                             found.pose.camera_T_head, c == 0 ? Sides::left : Sides::right);
    if (identityOf(rig_, points_, *found.then, own).side_share[c] < kSideFound)
      return SidesVerdict::one_camera;
  }
  return SidesVerdict::out_of_step;
}

// Tries the reference first, then other key frames if the identity is undecided.
RecoveredFace FaceRecovery::tryFrom(const std::shared_ptr<const RecoveryPictures>& now,
                                    const Eigen::Isometry3d& start) const {
  RecoveredFace best;
  std::vector<std::shared_ptr<const SkinView>> views = {reference_};
  for (const auto& key : remembered_) views.push_back(key.view);
  for (const auto& view : views) {
    RecoveredFace found;
    found.pose = fitRecoveryPose(rig_, points_, *view, *now, start);
    found.pictures = now, found.then = view;
    found.identity = identityOf(rig_, points_, *view, found.pose);
    if (!best.then || found.identity.log_likelihood_ratio > best.identity.log_likelihood_ratio)
      best = std::move(found);
    if (best.identity.verdict() == Identity::Verdict::patient) break;
  }
  if (best.pose.is_valid) best.lines = epipolarOffset(rig_, best.pose.matches);
  // Firm skin that is not in place has moved in a way that the fit does not model. The pose comes from the
  // rest, so its variance grows as that of a smaller sample.
  if (best.identity.in_place_share > 0) best.pose.covariance /= best.identity.in_place_share;
  if (best.pose.is_valid && best.identity.verdict() != Identity::Verdict::other) best.sides = sidesOf(best);
  return best;
}

std::optional<RecoveredFace> FaceRecovery::find(const cameras::StereoFrame& frame,
                                                const std::optional<Eigen::Isometry3d>& last,
                                                bool is_thorough) const {
  const auto now = std::make_shared<const RecoveryPictures>(frame);
  std::optional<RecoveredFace> best;
  const auto isFoundFrom = [&](const Eigen::Isometry3d& start, bool is_face_seen) {
    RecoveredFace found = tryFrom(now, start);
    found.is_face_seen = is_face_seen;
    if (found.pose.is_valid &&
        (!best || found.identity.log_likelihood_ratio > best->identity.log_likelihood_ratio))
      best = std::move(found);
    return best && best->identity.verdict() == Identity::Verdict::patient;
  };
  if (last && isFoundFrom(*last, false)) return best;
  std::optional<Eigen::Isometry3d> start = last;
  if (!landmarks_mm_.empty())
    if (const auto face = is_thorough ? face::findStereoFace(*detector_, rig_, frame)
                                      : face::findStereoFaceAtRoll(*detector_, rig_, frame, roll_rad_))
      if (const auto motion = face::motionOfLandmarks(landmarks_mm_, face->points_mm)) {
        start = motion;
        if (isFoundFrom(*motion, true)) return best;
      }
  if (const auto shape = shape_.fit(rig_, frame, start.value_or(Eigen::Isometry3d::Identity())))
    isFoundFrom(*shape, false);
  return best;
}

Matrix6d FaceRecovery::carried(const RecoveryPose& pose, const Matrix6d& covariance,
                               const Eigen::Vector3d& centre_mm) const {
  Matrix6d carry = Matrix6d::Identity();
  carry.bottomLeftCorner<3, 3>() = -skew(pose.camera_T_head.linear() * (centre_mm - points_.centre_mm()));
  return carry * covariance * carry.transpose();
}

void FaceRecovery::remember(const RecoveredFace& found, const cameras::StereoFrame& frame) {
  auto view = std::make_shared<SkinView>();
  view->rig = rig_;
  view->pictures = *found.pictures;
  view->camera_T_head = found.pose.camera_T_head;
  view->covariance = found.pose.covariance;
  Remembered key{view, std::nullopt};
  if (found.then == reference_)
    key.learnt = FaceKeyFrame{rig_, points_.faceOnly(frame, rig_, view->camera_T_head), view->camera_T_head,
                              view->covariance};
  add(std::move(key));
}

void FaceRecovery::add(const FaceKeyFrame& key) {
  auto view = std::make_shared<SkinView>();
  view->rig = key.rig;
  view->pictures = RecoveryPictures(key.frame);
  view->camera_T_head = key.camera_T_head;
  view->covariance = key.covariance, view->between_sessions = key.between_sessions;
  add(Remembered{view, std::nullopt});
}

// Adds a key frame. When full, removes the older of the two key frames with the most similar poses.
void FaceRecovery::add(Remembered key) {
  remembered_.push_back(std::move(key));
  if (remembered_.size() <= kMostRemembered) return;
  const auto apart = [&](std::size_t i, std::size_t j) {
    const Eigen::Isometry3d step =
        remembered_[i].view->camera_T_head.inverse() * remembered_[j].view->camera_T_head;
    return (step * points_.centre_mm() - points_.centre_mm()).norm() +
           kTurn_mm * rotationAngle(step.linear());
  };
  std::size_t oldest = 0;
  double least = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i + 1 < remembered_.size(); ++i)
    for (std::size_t j = i + 1; j < remembered_.size(); ++j)
      if (apart(i, j) < least) least = apart(i, j), oldest = i;
  remembered_.erase(remembered_.begin() + std::ptrdiff_t(oldest));
}

std::vector<FaceKeyFrame> FaceRecovery::learnt() const {
  std::vector<FaceKeyFrame> keys;
  for (const auto& key : remembered_)
    if (key.learnt) keys.push_back(*key.learnt);
  return keys;
}

void FaceRecovery::forgetRemembered() { remembered_.clear(); }

}  // namespace facenav::head_tracking
