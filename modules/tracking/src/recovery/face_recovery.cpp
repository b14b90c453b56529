#include "face_recovery.h"

#include <algorithm>

namespace facenav::tracking {
namespace {

constexpr std::size_t kMostRemembered =
    6;  // moments: each costs one more fit where the reference does not do

// Squared distance of the two cameras' own poses by their covariance. In step: 36 at most (45 pairs of one
// real person, three rigs); out of step by 1 degree or 3 mm: 60 and more.
constexpr double kApart = 60.0;
constexpr double kUneven = 0.5;      // share of windows in place in one camera, by that in the other
constexpr double kSideFound = 0.35;  // of one camera's windows: it shows the patient's face

}  // namespace

FaceRecovery::FaceRecovery(const stereo::StereoRig& rig, const stereo::StereoFrame& reference,
                           const FaceRegion& region, const FaceSurface& surface,
                           const std::optional<StereoFace>& face,
                           std::shared_ptr<const FaceDetector> detector)
    : rig_(rig), detector_(std::move(detector)) {
  const SkinMobility mobility = face ? SkinMobility(face->left) : SkinMobility();
  points_ = SkinPoints(rig, reference, region, surface, mobility);
  shape_ = FaceShape(rig, region, surface, mobility);
  if (face) landmarks_mm_ = face->points_mm, roll_rad_ = face->left.roll_rad;
  views_.push_back(std::make_shared<SkinView>(points_.reference()));
}

SidesVerdict FaceRecovery::sidesOf(const RecoveredFace& found) const {
  const auto& share = found.identity.side_share;
  const bool is_even = std::min(share[0], share[1]) > kUneven * std::max(share[0], share[1]);
  if (is_even && found.pose.sides_apart)
    return *found.pose.sides_apart > kApart ? SidesVerdict::out_of_step : SidesVerdict::agree;
  for (const std::size_t c : {0u, 1u}) {  // does each show the face, wherever it is?
    const RecoveryPose own = fitRecoveryPose(rig_, points_, *found.then, *found.pictures,
                                             found.pose.camera_T_head, c == 0 ? Sides::left : Sides::right);
    if (identityOf(rig_, points_, *found.then, own, std::nullopt).side_share[c] < kSideFound)
      return SidesVerdict::one_camera;
  }
  return SidesVerdict::out_of_step;
}

// The reference first; moments remembered since where it does not decide.
RecoveredFace FaceRecovery::tryFrom(const stereo::StereoFrame& frame,
                                    const std::shared_ptr<const RecoveryPictures>& now,
                                    const Eigen::Isometry3d& start) const {
  RecoveredFace best;
  for (const auto& view : views_) {
    RecoveredFace found;
    found.pose = fitRecoveryPose(rig_, points_, *view, *now, start);
    found.pictures = now, found.then = view;
    found.identity = identityOf(rig_, points_, *view, found.pose, std::nullopt);
    if (!best.then || found.identity.log_likelihood_ratio > best.identity.log_likelihood_ratio)
      best = std::move(found);
    if (best.identity.verdict() == Identity::Verdict::patient) break;
  }
  if (best.pose.is_valid && best.identity.verdict() == Identity::Verdict::undecided)
    if (const auto shape = shape_.fit(rig_, frame, best.pose.camera_T_head))
      best.identity = identityOf(rig_, points_, *best.then, best.pose, shape);
  if (best.pose.is_valid && best.identity.verdict() != Identity::Verdict::other) best.sides = sidesOf(best);
  return best;
}

std::optional<RecoveredFace> FaceRecovery::find(const stereo::StereoFrame& frame,
                                                const std::optional<Eigen::Isometry3d>& last,
                                                bool is_thorough) const {
  const auto now = std::make_shared<const RecoveryPictures>(frame);
  std::optional<RecoveredFace> best;
  const auto isFoundFrom = [&](const Eigen::Isometry3d& start, bool is_face_seen) {
    RecoveredFace found = tryFrom(frame, now, start);
    found.is_face_seen = is_face_seen;
    if (found.pose.is_valid &&
        (!best || found.identity.log_likelihood_ratio > best->identity.log_likelihood_ratio))
      best = std::move(found);
    return best && best->identity.verdict() == Identity::Verdict::patient;
  };
  if (last && isFoundFrom(*last, false)) return best;
  std::optional<Eigen::Isometry3d> start = last;
  if (!landmarks_mm_.empty())
    if (const auto face = is_thorough ? findStereoFace(*detector_, rig_, frame)
                                      : findStereoFaceAtRoll(*detector_, rig_, frame, roll_rad_))
      if (const auto motion = motionOfLandmarks(landmarks_mm_, face->points_mm)) {
        start = motion;
        if (isFoundFrom(*motion, true)) return best;
      }
  if (const auto shape = shape_.fit(rig_, frame, start.value_or(Eigen::Isometry3d::Identity())))
    isFoundFrom(shape->camera_T_head, false);
  return best;
}

Matrix6d FaceRecovery::covarianceAbout(const RecoveryPose& pose, const Eigen::Vector3d& centre_mm) const {
  Matrix6d carry = Matrix6d::Identity();
  carry.bottomLeftCorner<3, 3>() = -skew(pose.camera_T_head.linear() * (centre_mm - points_.centre_mm()));
  return carry * pose.covariance * carry.transpose();
}

void FaceRecovery::remember(const std::shared_ptr<const RecoveryPictures>& pictures,
                            const RecoveryPose& pose) {
  if (views_.size() > kMostRemembered) views_.erase(views_.begin() + 1);
  auto view = std::make_shared<SkinView>();
  view->rig = rig_;
  view->pictures = *pictures;
  view->camera_T_head = pose.camera_T_head;
  view->covariance = pose.covariance;
  views_.push_back(std::move(view));
}

}  // namespace facenav::tracking
