#include "facenav/peers/feature_head_tracker.h"

// "features7": the paper's head tracker (section 4). Seven features, templates of the reference frame, NCC in
// both images (equations 3-5), closed-form pose with NCC weights (equation 2). Beyond the paper: templates
// are warped to the predicted pose (a plane through the feature), the geometry is checked and the pose
// refined in the images (feature_fit.h), and face detection runs only when prediction fails.

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "facenav/face/stereo_face.h"
#include "feature_fit.h"
#include "frame_guard.h"
#include "head/head_motion.h"
#include "ncc.h"
#include "plane_warp.h"

namespace facenav::peers {
namespace {

using namespace head_tracking;

constexpr std::array<int, 7> kLandmarks = {36, 39, 42, 45,
                                           30, 48, 54};  // iBUG: eye corners, nose tip, mouth corners
constexpr double kTemplateShare = 0.19;  // edge of the template by the distance of the outer eye corners
constexpr double kLeastNcc = 0.6;

struct Feature {
  Eigen::Vector3d p_mm;
  Eigen::Vector2d left_px, right_px;  // in the reference frame
};

cv::Rect boundingBox(const std::vector<FaceFeature>& features, bool is_left) {
  std::vector<cv::Point2f> points;
  for (const auto& f : features) {
    const auto& px = is_left ? f.left_px : f.right_px;
    points.emplace_back(float(px.x()), float(px.y()));
  }
  return points.empty() ? cv::Rect() : cv::boundingRect(points);
}

class FeatureHeadTracker : public HeadTracker {
 public:
  explicit FeatureHeadTracker(std::shared_ptr<const face::FaceDetector> detector)
      : detector_(detector ? std::move(detector) : face::makeFaceDetector()) {}

  using HeadTracker::start;
  using HeadTracker::track;

  void start(const cameras::StereoRig& rig, const HeadReference& reference, Pace) override {
    rig_ = rig;
    drawn_.clear();
    last_.reset();
    reference_ = {reference.frame.left.clone(), reference.frame.right.clone(), 0, {}};
    const auto face = face::findStereoFace(*detector_, rig, reference.frame);
    if (!face)
      throw Error("no face is found in both images of the reference frame", {},
                  "turn the face towards the cameras and light it evenly");
    if (face->points_mm.size() != 68)
      throw Error("the head tracker 'features7' needs the face landmark model", {},
                  "install the package libdlib-data");
    reference_face_ = *face;
    seen_face_ = *face;
    learnFeatures(*face);
    guard_.start(reference.frame);
  }

  HeadResult track(const cameras::StereoFrame& frame, const HeadContext&) override {
    FACENAV_EXPECT(!features_.empty(), "track() before start()");
    return poseIn(frame);
  }

 private:
  Tracked<HeadPose> poseIn(const cameras::StereoFrame& frame) {
    const double speed_mm_s = last_ ? last_->velocity.tail<3>().norm() : 0.0;
    const auto fault = guard_.check(frame, speed_mm_s, boundingBox(drawn_, true), boundingBox(drawn_, false));
    if (fault) return lost(*fault);
    if (const auto predicted = predict(frame.captured))
      if (const auto pose = attempt(frame, *predicted, 10)) return accepted(frame, pose);
    return relocalise(frame);
  }

  struct Last {
    Eigen::Isometry3d motion;
    Vector6d velocity;  // 1/s, about the face's centre
    Eigen::Vector3d centre_mm;
    Timestamp captured;
  };

  void learnFeatures(const face::StereoFace& face) {
    const double eyes_px = (face.left.points68[36] - face.left.points68[45]).norm();
    half_ = std::max(5, int(std::lround(0.5 * kTemplateShare * eyes_px)));
    features_.clear();
    for (int landmark : kLandmarks) {
      const Eigen::Vector2d at(std::round(face.left.points68[landmark].x()),
                               std::round(face.left.points68[landmark].y()));
      const auto match = matchInReference(at, face.right.points68[landmark]);
      if (!match) continue;
      features_.push_back({cameras::triangulate(rig_, at, *match).mm, at, *match});
    }
    if (features_.size() < 5)
      throw Error("only " + std::to_string(features_.size()) +
                      " of the 7 face features are found in both images of the reference frame",
                  {}, "take the reference frame with the whole face in view of both cameras");
    points_mm_.clear();
    for (const auto& feature : features_) points_mm_.push_back(feature.p_mm);
    normal_ = facePlaneNormal(points_mm_);
  }

  std::optional<Eigen::Vector2d> matchInReference(const Eigen::Vector2d& left_px,
                                                  const Eigen::Vector2d& right_guess_px) const {
    const cv::Mat patch = cutPatch(reference_.left, left_px, Eigen::Matrix2d::Identity(), half_);
    const auto peak = findPeak(reference_.right, patch, right_guess_px, std::max(8, half_));
    if (!peak || peak->ncc < kLeastNcc) return std::nullopt;
    if (cameras::epipolarError_px(rig_, left_px, peak->px) > 2.0) return std::nullopt;
    return peak->px;
  }

  std::optional<Eigen::Isometry3d> predict(Timestamp at) const {
    if (!last_) return std::nullopt;
    const double dt_s = at - last_->captured;
    if (dt_s < 0 || dt_s > kMoment_s) return std::nullopt;
    const Vector6d step = last_->velocity * dt_s;
    return Eigen::Translation3d(last_->centre_mm) * expRigid(step) * Eigen::Translation3d(-last_->centre_mm) *
           last_->motion;
  }

  // Searches in a wide area at the predicted pose, then again near the result with templates warped to it.
  Tracked<FeatureFit> attempt(const cameras::StereoFrame& frame, const Eigen::Isometry3d& predicted,
                              int radius_px) const {
    Tracked<FeatureFit> found = fitFeatures(rig_, points_mm_, search(frame, predicted, radius_px));
    for (int round = 0; found && round < 2; ++round)
      found = fitFeatures(rig_, points_mm_, search(frame, found->motion, 3));
    return found;
  }

  std::vector<FeatureMatch> search(const cameras::StereoFrame& frame, const Eigen::Isometry3d& motion,
                                   int radius_px) const {
    const Eigen::Isometry3d identity = Eigen::Isometry3d::Identity(), right = rig_.right_T_left.isometry();
    std::vector<FeatureMatch> matches;
    for (int i = 0; i < int(features_.size()); ++i) {
      const auto& feature = features_[i];
      const PlaneWarp left_warp = warpOfPlane(rig_.left, identity, feature.p_mm, normal_, motion);
      const PlaneWarp right_warp = warpOfPlane(rig_.right, right, feature.p_mm, normal_, motion);
      if (!left_warp.is_visible || !right_warp.is_visible) continue;
      const auto left = findPeak(
          frame.left, cutPatch(reference_.left, feature.left_px, left_warp.reference_from_now, half_),
          left_warp.px, radius_px);
      const auto right_peak = findPeak(
          frame.right, cutPatch(reference_.right, feature.right_px, right_warp.reference_from_now, half_),
          right_warp.px, radius_px);
      if (!left || !right_peak || std::min(left->ncc, right_peak->ncc) < kLeastNcc) continue;
      matches.push_back({i, left->px, right_peak->px, std::min({left->ncc, right_peak->ncc, 1.0})});
    }
    return matches;
  }

  Tracked<HeadPose> relocalise(const cameras::StereoFrame& frame) {
    auto face = face::findStereoFace(*detector_, rig_, frame, &seen_face_);
    if (!face) face = face::findStereoFaceAtRoll(*detector_, rig_, frame, reference_face_.left.roll_rad);
    if (!face) return lost(LostReason::no_face);
    seen_face_ = *face;
    const auto motion = face::motionOfLandmarks(reference_face_.points_mm, face->points_mm);
    if (!motion) return lost(LostReason::high_residual);
    const auto pose = attempt(frame, *motion, std::max(10, half_));
    return pose ? accepted(frame, pose) : lost(pose.reason());
  }

  Tracked<HeadPose> lost(LostReason reason) {
    if (last_) last_->velocity.setZero();
    return Lost{reason};
  }

  Tracked<HeadPose> accepted(const cameras::StereoFrame& frame, const Tracked<FeatureFit>& fit) {
    remember(*fit, frame.captured);
    HeadPose pose;
    pose.camera_T_head = RigidTransform<Camera, Head>::fromIsometry(fit->motion);
    pose.covariance = fit->covariance;
    pose.face_centre = Point<Camera>(fit->centre_mm);
    for (const auto& match : fit->inliers)
      pose.features.push_back({match.left_px, match.right_px, match.weight});
    drawn_ = pose.features;
    pose.face_left = boundingBox(drawn_, true);
    return {pose, fit.quality()};
  }

  void remember(const FeatureFit& fit, Timestamp captured) {
    Vector6d velocity = Vector6d::Zero();
    const double dt_s = last_ ? captured - last_->captured : 0.0;
    if (dt_s > 1e-4 && dt_s < kMoment_s) {
      const Eigen::Isometry3d step = fit.motion * last_->motion.inverse();
      velocity.head<3>() = logRotation(step.linear()) / dt_s;
      velocity.tail<3>() = (step * last_->centre_mm - last_->centre_mm) / dt_s;
    }
    last_ = Last{fit.motion, velocity, fit.centre_mm, captured};
  }

  std::shared_ptr<const face::FaceDetector> detector_;
  cameras::StereoRig rig_;
  cameras::StereoFrame reference_;
  face::StereoFace reference_face_, seen_face_;
  std::vector<Feature> features_;
  std::vector<Eigen::Vector3d> points_mm_;
  Eigen::Vector3d normal_ = -Eigen::Vector3d::UnitZ();
  int half_ = 10;
  FrameGuard guard_;
  std::optional<Last> last_;
  std::vector<FaceFeature> drawn_;
};

}  // namespace

std::unique_ptr<HeadTracker> makeFeatureHeadTracker(std::shared_ptr<const face::FaceDetector> detector) {
  return std::make_unique<FeatureHeadTracker>(std::move(detector));
}

}  // namespace facenav::peers
