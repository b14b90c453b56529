// "model": the default head tracker. Hundreds of skin patches, learnt once from the reference frame and the
// dense cloud, fitted jointly in both images (pose_fit.h) from a constant-velocity prediction, always against
// the reference, so nothing drifts. What is shown as tracked has passed the tests of track_verdict.h.

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "coarse_search.h"
#include "facenav/tracking/head_tracker.h"
#include "frame_guard.h"
#include "patch_model.h"
#include "pose_fit.h"
#include "stereo_face.h"
#include "track_verdict.h"

namespace facenav::tracking {
namespace {

constexpr double kLongestGap_s = 0.3;   // beyond it a prediction is worth nothing
constexpr double kTrustMemory_s = 0.7;  // over which a patch shows whether it moves by itself
constexpr double kRollStep_rad = 25 * M_PI / 180;

class ModelHeadTracker : public HeadTracker {
 public:
  explicit ModelHeadTracker(std::shared_ptr<const FaceDetector> detector)
      : detector_(detector ? std::move(detector) : makeFaceDetector()) {}

  void start(const stereo::StereoRig& rig, const HeadReference& reference) override {
    const auto face = findStereoFace(*detector_, rig, reference.frame);
    if (!face && reference.surface.empty())
      throw Error("no face is found in both images of the reference frame", {},
                  "let the face look towards the cameras, lit evenly");
    const cv::Size size = reference.frame.left.size();
    const FaceRegion region =
        face ? FaceRegion(face->left, size) : FaceRegion(reference.surface_left_px, size);
    const FaceSurface surface = measureSurface(rig, reference, region, face ? depthOf(rig, *face) : 0.0);
    const std::array<ImagePyramid, 2> key = {ImagePyramid(reference.frame.left),
                                             ImagePyramid(reference.frame.right)};
    model_ = learnPatches(rig, key, region, surface);
    model_.shape_doubt = reference.surface.empty() ? 4.0 : 1.0;
    if (model_.level[0].patches.size() < 30)
      throw Error("no face with enough texture and depth is found in the reference frame", {},
                  "look for blur, darkness or a covered face");
    rig_ = rig;
    reference_face_ = seen_face_ = face.value_or(StereoFace{});
    coarse_ = CoarseSearch(rig, key, model_);
    left_box_ = right_box_ = face ? face->left.face : region.box();
    last_.reset();
    wander_.assign(model_.level[0].patches.size(), 0.0);
    lost_frames_ = 0;
    guard_.start(reference.frame);
  }

  Tracked<HeadPose> track(const stereo::StereoFrame& frame) override {
    const auto fault =
        guard_.check(frame, last_ ? last_->velocity.tail<3>().norm() : 0.0, left_box_, right_box_);
    if (fault) return lost(*fault);
    const std::array<ImagePyramid, 2> now = {ImagePyramid(frame.left), ImagePyramid(frame.right)};
    LostReason reason = LostReason::no_face;
    if (last_) {
      const double dt_s = frame.captured - last_->captured;
      const bool is_recent = dt_s >= 0 && dt_s < kLongestGap_s;
      const PoseFit fit =
          fitPose(rig_, model_, now, is_recent ? predict(dt_s) : last_->motion, is_recent ? 2 : 3, trust());
      const Verdict verdict = judge(rig_, model_, fit);
      if (verdict.isTracked()) return accepted(frame, fit, verdict);
      reason = *verdict.lost;
    }
    return relocalise(frame, now, reason);
  }

 private:
  struct Last {
    Eigen::Isometry3d motion;
    Vector6d velocity;  // per s, Head, about the model's centre
    Timestamp captured;
  };

  double depthOf(const stereo::StereoRig& rig, const StereoFace& face) const {
    std::vector<double> depths_mm;
    for (const auto& p_mm : face.points_mm) depths_mm.push_back(p_mm.z());
    if (depths_mm.empty()) {
      const auto centre = [](const cv::Rect& r) {
        return Eigen::Vector2d(r.x + 0.5 * r.width, r.y + 0.5 * r.height);
      };
      return stereo::triangulate(rig, centre(face.left.face), centre(face.right.face)).mm.z();
    }
    std::nth_element(depths_mm.begin(), depths_mm.begin() + depths_mm.size() / 2, depths_mm.end());
    return depths_mm[depths_mm.size() / 2];
  }

  Eigen::Isometry3d predict(double dt_s) const {
    return last_->motion * Eigen::Translation3d(model_.centre_mm) * expRigid(last_->velocity * dt_s) *
           Eigen::Translation3d(-model_.centre_mm);
  }

  std::vector<double> trust() const {
    std::vector<double> factors;
    for (double wander : wander_) factors.push_back(1.0 / (1.0 + wander / 4.0));
    return factors;
  }

  Tracked<HeadPose> relocalise(const stereo::StereoFrame& frame, const std::array<ImagePyramid, 2>& now,
                               LostReason reason) {
    const auto start = startOf(frame, now);
    if (!start) return lost(reason);
    const PoseFit fit = fitPose(rig_, model_, now, *start, 3, trust());
    const Verdict verdict = judge(rig_, model_, fit);
    return verdict.isTracked() ? accepted(frame, fit, verdict) : lost(*verdict.lost);
  }

  // From landmarks where a face is detected, else from the looks of the whole face.
  std::optional<Eigen::Isometry3d> startOf(const stereo::StereoFrame& frame,
                                           const std::array<ImagePyramid, 2>& now) {
    if (!reference_face_.points_mm.empty() && lost_frames_ % 4 != 3) {
      auto face = findStereoFace(*detector_, rig_, frame, &seen_face_);
      if (!face) face = searchFace(frame);
      if (face) {
        seen_face_ = *face;
        if (const auto motion = motionOfLandmarks(reference_face_.points_mm, face->points_mm)) return motion;
      }
    }
    return coarse_.find(rig_, now);
  }

  // The whole image at one roll per frame: upright as in the reference, then leaning to either side.
  std::optional<StereoFace> searchFace(const stereo::StereoFrame& frame) {
    const double lean[] = {0.0, kRollStep_rad, -kRollStep_rad};
    return findStereoFaceAtRoll(*detector_, rig_, frame,
                                reference_face_.left.roll_rad + lean[lost_frames_ % 3]);
  }

  Tracked<HeadPose> lost(LostReason reason) {
    ++lost_frames_;
    if (last_) last_->velocity.setZero();
    return Lost{reason};
  }

  Tracked<HeadPose> accepted(const stereo::StereoFrame& frame, const PoseFit& fit, const Verdict& verdict) {
    learnTrust(frame.captured, fit);
    remember(frame.captured, fit);
    HeadPose pose;
    pose.camera_T_head = RigidTransform<Camera, Head>::fromIsometry(fit.motion);
    pose.covariance = verdict.covariance;
    pose.face_centre = Point<Camera>(fit.motion * model_.centre_mm);
    pose.features = featuresOf(fit);
    left_box_ = boxOf(fit, 0), right_box_ = boxOf(fit, 1);
    pose.face_left = left_box_;
    return {pose, verdict.quality};
  }

  static std::vector<FaceFeature> featuresOf(const PoseFit& fit) {
    std::vector<FaceFeature> features;
    for (const auto& sight : fit.sights)
      if (sight[0].is_visible && sight[1].is_visible)
        features.push_back({sight[0].px, sight[1].px, std::min(sight[0].weight, sight[1].weight)});
    return features;
  }

  static cv::Rect boxOf(const PoseFit& fit, int camera) {
    std::vector<cv::Point> points;
    for (const auto& sight : fit.sights)
      if (sight[camera].is_visible) points.emplace_back(int(sight[camera].px.x()), int(sight[camera].px.y()));
    return points.empty() ? cv::Rect() : cv::boundingRect(points);
  }

  // Skin that keeps wandering about the rigid fit (lips, jaw, lids) loses its say.
  void learnTrust(Timestamp captured, const PoseFit& fit) {
    const double dt_s = last_ ? std::clamp(captured - last_->captured, 0.0, 0.1) : 0.03;
    const double share = 1.0 - std::exp(-dt_s / kTrustMemory_s);
    for (std::size_t i = 0; i < wander_.size(); ++i) {
      double seen = -1.0;
      for (const auto& sight : fit.sights[i])
        if (sight.is_visible) seen = std::max(seen, std::min(sight.distance * sight.distance, 50.0));
      if (seen >= 0) wander_[i] += share * (std::max(0.0, seen - 4.0) - wander_[i]);
    }
  }

  void remember(Timestamp captured, const PoseFit& fit) {
    Vector6d velocity = Vector6d::Zero();
    const double dt_s = last_ ? captured - last_->captured : 0.0;
    if (dt_s > 1e-4 && dt_s < kLongestGap_s) {
      const Eigen::Isometry3d step = last_->motion.inverse() * fit.motion;
      velocity.head<3>() = logRotation(step.linear()) / dt_s;
      velocity.tail<3>() = (step * model_.centre_mm - model_.centre_mm) / dt_s;
    }
    last_ = Last{fit.motion, velocity, captured};
    lost_frames_ = 0;
  }

  std::shared_ptr<const FaceDetector> detector_;
  stereo::StereoRig rig_;
  PatchModel model_;
  StereoFace reference_face_, seen_face_;
  CoarseSearch coarse_;
  FrameGuard guard_;
  std::optional<Last> last_;
  std::vector<double> wander_;  // per patch of level 0: mean square distance beyond the expected
  cv::Rect left_box_, right_box_;
  int lost_frames_ = 0;
};

}  // namespace

std::unique_ptr<HeadTracker> makeModelHeadTracker(std::shared_ptr<const FaceDetector> detector) {
  return std::make_unique<ModelHeadTracker>(std::move(detector));
}

}  // namespace facenav::tracking
