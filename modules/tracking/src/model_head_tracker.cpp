// "model": the default head tracker. Hundreds of skin patches, learnt from the reference frame and the dense
// cloud, fitted jointly in both images (pose_fit.h) from a constant-velocity prediction, always against the
// reference or a key frame made from it (key_frames.h), so nothing drifts. What is shown as tracked has
// passed the tests of track_verdict.h. Face detection runs at start only: a cascade takes tens of
// milliseconds, while the face's own pictures (coarse_search.h) find it again within a few frames of a few
// milliseconds each.

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "coarse_search.h"
#include "facenav/tracking/head_tracker.h"
#include "frame_guard.h"
#include "key_frames.h"
#include "patch_model.h"
#include "patch_placement.h"
#include "pose_fit.h"
#include "skin_detail.h"
#include "stereo_face.h"
#include "track_verdict.h"

namespace facenav::tracking {
namespace {

constexpr double kLongestGap_s = 0.3;    // beyond it a prediction is worth nothing
constexpr double kTrustMemory_s = 0.7;   // over which a patch shows whether it moves by itself
constexpr double kLeastLikeness = 0.15;  // after it: less is no face
constexpr double kLikely = 0.8;          // the head is there, about
constexpr double kSwappedLikeness = 0.4, kSurelySwapped = 0.1;  // by exchanging the images
constexpr double kFar = 1.6, kBlurred = 0.6;  // by the reference's distance, by its fine detail
constexpr double kNoiseInDetail = 0.041;  // variance of level 1 less its 3 x 3 mean, by that of the sensor
constexpr std::size_t kAskedParts = 8;    // of the patches, one a tracked frame: whose skin it is
constexpr int kMargin_px = 20;  // about the patches' centres: half a patch, and the motion left to find

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
    model_ = learnPatches(rig, reference.frame, key, region, surface);
    model_.shape_doubt = reference.surface.empty() ? 4.0 : 1.0;
    if (model_.level[0].patches.size() < 30)
      throw Error("no face with enough texture and depth is found in the reference frame", {},
                  "look for blur, darkness or a covered face");
    rough_level_ = model_.level[2].patches.size() < kFewestPatches ? 1 : 2;
    rig_ = rig;
    both_cameras_ = detailOfBothCameras(model_);
    keys_ = KeyFrames(model_);
    coarse_ = reference_search_ =
        CoarseSearch(rig, key, FaceTemplate(rig, region, surface, model_.centre_mm));
    left_box_ = right_box_ = face ? face->left.face : region.box();
    last_.reset();
    wander_.assign(model_.level[0].patches.size(), 0.0);
    lost_frames_ = 0, asked_part_ = 0;
    detail_at_start_ = detailIn(key[0]);
    guard_.start(reference.frame);
  }

  Tracked<HeadPose> track(const stereo::StereoFrame& frame) override {
    const auto fault =
        guard_.check(frame, last_ ? last_->velocity.tail<3>().norm() : 0.0, left_box_, right_box_);
    if (fault) return refused(*fault);
    const double dt_s = last_ ? frame.captured - last_->captured : 0.0;
    const bool is_recent = last_ && dt_s >= 0 && dt_s < kLongestGap_s;
    if (is_recent && lost_frames_ == 0) {
      const Eigen::Isometry3d predicted = predict(dt_s);
      const KeyFrame& key = keys_.nearest(predicted);
      const auto now = boxed(frame, predicted);
      const PoseFit fit = fitPose(rig_, model_, key.level, now, predicted, 0, trust());
      const Verdict verdict = judge(model_, fit, key.covariance);
      if (verdict.isTracked() && !isAnothers(key, now, fit)) {
        learnSides(frame, fit, verdict);
        return accepted(frame, fit, verdict);
      }
    }
    return recover(frame, is_recent ? std::optional(predict(dt_s)) : std::nullopt);
  }

  LossDetail lossDetail() const override { return detail_; }

  void forgetLearnt() override {
    keys_ = KeyFrames(model_);
    coarse_ = reference_search_;
    wander_.assign(model_.level[0].patches.size(), 0.0);
    last_.reset();
    lost_frames_ = 0;
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

  // Level 0 of the parts of both images where the face is expected.
  std::array<ImagePyramid, 2> boxed(const stereo::StereoFrame& frame, const Eigen::Isometry3d& motion) const {
    const auto boxes = boxesAt(rig_, model_, motion, kMargin_px);
    std::array<ImagePyramid, 2> now;
    now[0].level[0] = blurredPart(frame.left, boxes[0]);
    now[1].level[0] = blurredPart(frame.right, boxes[1]);
    return now;
  }

  std::vector<float> trust() const {
    std::vector<float> factors;
    for (double wander : wander_) factors.push_back(float(1.0 / (1.0 + wander / 4.0)));
    return factors;
  }

  // Somebody else, put in the patient's place between two frames. A part of the patches is asked in each, all
  // of them where that part is in doubt.
  bool isAnothers(const KeyFrame& key, const std::array<ImagePyramid, 2>& now, const PoseFit& fit) {
    asked_part_ = (asked_part_ + 1) % kAskedParts;
    return whose(key, now, fit, {kAskedParts, asked_part_}) != Whose::patients &&
           whose(key, now, fit) == Whose::anothers;
  }

  Whose whose(const KeyFrame& key, const std::array<ImagePyramid, 2>& now, const PoseFit& fit,
              const PatchShare& share = {}) const {
    return whoseSkin(detailAgreement(rig_, model_, key.level[0], now, fit, share), both_cameras_);
  }

  // The prediction failed. A coarse fit from there; where that leads nowhere, from wherever the face seems to
  // be, some of the views a frame: the one after which the patches look most as they should is fitted to the
  // end, and shown only if the skin is the patient's.
  Tracked<HeadPose> recover(const stereo::StereoFrame& frame,
                            const std::optional<Eigen::Isometry3d>& expected) {
    const std::array<ImagePyramid, 2> now = {ImagePyramid::coarse(frame.left),
                                             ImagePyramid::coarse(frame.right)};
    PoseFit best;
    if (last_) best = roughly(now, expected.value_or(last_->motion));
    if (best.likeness > kLikely && lost_frames_ == 0) {  // lost to a quick move at most
      const auto there = attempt(frame, now, best.motion);
      if (there.verdict.isTracked()) return accepted(frame, there.fit, there.verdict);
      return lost(*there.verdict.lost, detailOf(there, now));
    }
    bool is_anything_alike = false;
    const auto lookFrom = [&](const std::optional<Eigen::Isometry3d>& from) {
      for (const auto& start : coarse_.find(rig_, now, from, lost_frames_)) {
        is_anything_alike = true;
        if (best.likeness > kLikely) break;
        const PoseFit rough = roughly(now, start, rough_level_);
        if (rough.likeness > best.likeness) best = rough;
      }
    };
    lookFrom(last_ ? std::optional(last_->motion) : std::nullopt);
    if (last_ && lost_frames_ == 0 && best.likeness < kLikely)
      lookFrom(std::nullopt);  // a leap, of a few frames a second
    if (last_ && best.likeness < kLikely &&
        roughly({now[1], now[0]}, last_->motion).likeness >
            std::max(kSwappedLikeness, best.likeness + kSurelySwapped))
      return lost(LostReason::camera, LossDetail::swapped);
    if (best.likeness < kLeastLikeness)
      return lost(LostReason::no_face,
                  circumstance(last_ ? last_->motion : Eigen::Isometry3d::Identity(), now)
                      .value_or(is_anything_alike ? LossDetail::doubtful : LossDetail::not_found));
    const auto there = attempt(frame, now, best.motion);
    if (there.verdict.isTracked()) return accepted(frame, there.fit, there.verdict);
    return lost(*there.verdict.lost, detailOf(there, now));
  }

  PoseFit roughly(const std::array<ImagePyramid, 2>& now, const Eigen::Isometry3d& start,
                  int first_level = kLevels - 1) const {
    return fitPose(rig_, model_, keys_.likeliest(start).level, now, start, first_level, {}, rough_level_);
  }

  struct Attempt {
    PoseFit fit;
    Verdict verdict;
  };

  Attempt attempt(const stereo::StereoFrame& frame, const std::array<ImagePyramid, 2>& now,
                  const Eigen::Isometry3d& start) {
    const KeyFrame& key = keys_.nearest(start);
    const Eigen::Isometry3d nearly =
        fitPose(rig_, model_, key.level, now, start, rough_level_ - 1, {}, rough_level_ - 1).motion;
    const auto finest = boxed(frame, nearly);
    PoseFit fit = fitPose(rig_, model_, key.level, finest, nearly, 0, trust());
    Verdict verdict = judge(model_, fit, key.covariance);
    if (verdict.isTracked() && whose(key, finest, fit) != Whose::patients) verdict.lost = LostReason::no_face;
    return {std::move(fit), std::move(verdict)};
  }

  // In words only: where patches look as they should, but too few, the rest is covered.
  LossDetail detailOf(const Attempt& there, const std::array<ImagePyramid, 2>& now) const {
    if (const auto detail = circumstance(there.fit.motion, now)) return *detail;
    switch (*there.verdict.lost) {
      case LostReason::camera:
        return LossDetail::one_camera;
      case LostReason::few_features:
        return LossDetail::covered;
      default:
        return LossDetail::doubtful;
    }
  }

  // What makes any face hard to see, wherever it is.
  std::optional<LossDetail> circumstance(const Eigen::Isometry3d& motion,
                                         const std::array<ImagePyramid, 2>& now) const {
    if ((motion * model_.centre_mm).z() > kFar * model_.centre_mm.z()) return LossDetail::too_far;
    if (detailIn(now[0]) < kBlurred * detail_at_start_) return LossDetail::blurred;
    return std::nullopt;
  }

  // How much of the face's contrast is fine detail: that between level 0 and 1, by that between 1 and 2.
  double detailIn(const ImagePyramid& image) const {
    const cv::Rect half(left_box_.x / 2, left_box_.y / 2, left_box_.width / 2, left_box_.height / 2);
    const cv::Mat1w& coarse = image.level[1].pixels;
    const cv::Rect box = half & cv::Rect({}, coarse.size());
    if (box.area() < 100) return detail_at_start_;
    cv::Mat1f grey, smooth, smoother;
    coarse(box).convertTo(grey, CV_32F, 1.0 / kGreyScale);
    cv::blur(grey, smooth, {3, 3});
    cv::blur(grey, smoother, {9, 9});
    const double fine = cv::norm(grey, smooth, cv::NORM_L2SQR) / box.area(),
                 noise = kNoiseInDetail * model_.noise_grey * model_.noise_grey;
    return std::sqrt(std::max(0.0, fine - noise) * box.area()) /
           (1e-3 + cv::norm(smooth, smoother, cv::NORM_L2));
  }

  // Pictures that are no news: the track goes on from before with the next good ones.
  Tracked<HeadPose> refused(LostReason fault) {
    detail_ = guard_.detail();
    return Lost{fault};
  }

  Tracked<HeadPose> lost(LostReason reason, LossDetail detail) {
    detail_ = detail;
    ++lost_frames_;
    if (last_) last_->velocity.setZero();
    keys_.forgetUnfinished();
    return Lost{reason};
  }

  // Not in a frame in which the head was looked for: that has cost enough.
  void learnSides(const stereo::StereoFrame& frame, const PoseFit& fit, const Verdict& verdict) {
    if (keys_.learn(rig_, model_, frame, fit, verdict))
      coarse_.add(rig_, {ImagePyramid::coarse(frame.left), ImagePyramid::coarse(frame.right)}, fit.motion);
  }

  Tracked<HeadPose> accepted(const stereo::StereoFrame& frame, const PoseFit& fit, const Verdict& verdict) {
    learnTrust(frame.captured, fit);
    detail_ = LossDetail::unknown;
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
        features.push_back({sight[0].px.cast<double>(), sight[1].px.cast<double>(),
                            double(std::min(sight[0].weight, sight[1].weight))});
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
        if (sight.is_visible) seen = std::max(seen, std::min(double(sight.distance * sight.distance), 50.0));
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
  int rough_level_ = 2;           // where fits that only choose a start end
  DetailAgreement both_cameras_;  // in the reference
  std::size_t asked_part_ = 0;
  KeyFrames keys_;
  CoarseSearch coarse_, reference_search_;  // the second: without what was learnt since start()
  LossDetail detail_ = LossDetail::unknown;
  double detail_at_start_ = 0.0;
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
