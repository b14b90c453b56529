// Head trackers on the same frames: the model tracker, the 2010 paper's seven features, and a tracker of
// OpenCV parts (corners of the reference followed by pyramidal Lucas-Kanade in both images, triangulated,
// rigid fit with robust weights). Error at a point 90 mm behind the face against exact truth; processor time
// of each frame on one core. Then the time of finding a lost face.

#include <cstdio>
#include <opencv2/core/utility.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/video/tracking.hpp>

#include "facenav/core/parallel_for.h"
#include "facenav/core/processor_time.h"
#include "facenav/geometry/pose_error.h"
#include "facenav/geometry/rigid_fit.h"
#include "facenav/geometry/rotation.h"
#include "facenav/head_tracking/head_tracker.h"
#include "facenav/peers/feature_head_tracker.h"
#include "support/stopwatch.h"
#include "support/synthetic_face.h"

using namespace facenav;
namespace support = facenav::testing;

namespace {

constexpr int kFrames = 20;
const Point<Head> kCortex(0, -60, 690);

struct Result {
  std::vector<double> error_mm, rotation_deg, time_ms;
  int lost = 0;
};

struct Motion {
  const char* name;
  double yaw_deg;
};

support::SyntheticView viewAt(int frame, double yaw_deg) {
  const double phase = 2 * M_PI * frame / 60.0;
  Vector6d xi;
  xi << 0.4 * yaw_deg * kRadPerDeg * std::sin(phase), yaw_deg * kRadPerDeg * std::sin(phase + 0.3),
      0.3 * yaw_deg * kRadPerDeg * std::cos(phase), 20 * std::sin(phase), 10 * std::cos(phase) - 10,
      15 * std::sin(2 * phase);
  support::SyntheticView view;
  view.motion = Eigen::Translation3d(0, 0, 640) * expRigid(xi) * Eigen::Translation3d(0, 0, -640);
  view.seed = std::uint64_t(frame) + 1;
  view.time_s = frame / 30.0;
  return view;
}

/// OpenCV's parts in the usual combination.
class LucasKanadeTracker {
 public:
  LucasKanadeTracker(const cameras::StereoRig& rig, const head_tracking::HeadReference& reference)
      : rig_(rig), left_(reference.frame.left), right_(reference.frame.right) {
    cv::Mat1b face(left_.size(), uchar(0));
    cv::Mat1i point(left_.size(), -1);
    for (std::size_t i = 0; i < reference.surface_left_px.size(); ++i) {
      const auto& px = reference.surface_left_px[i];
      face(int(px.y()), int(px.x())) = 255;
      cv::rectangle(point, cv::Rect(int(px.x()), int(px.y()), 2, 2), int(i), cv::FILLED);
    }
    cv::morphologyEx(face, face, cv::MORPH_CLOSE, cv::Mat1b::ones(5, 5));
    cv::erode(face, face, {}, {-1, -1}, 8);
    std::vector<cv::Point2f> corners;
    cv::goodFeaturesToTrack(left_, corners, 250, 0.005, 5, face);
    for (const auto& corner : corners) {
      const int i = point(int(corner.y), int(corner.x));
      if (i < 0) continue;
      const Eigen::Vector2d right =
          cameras::project(rig.right, rig.right_T_left.isometry() * reference.surface.points_mm[i]);
      corners_.push_back(corner), in_right_.emplace_back(float(right.x()), float(right.y()));
    }
    follow(left_, right_, corners_, in_right_, seen_right_);
    for (std::size_t i = 0; i < corners_.size(); ++i)
      reference_mm_.push_back(triangulated(corners_[i], in_right_[i]));
    last_left_ = corners_, last_right_ = in_right_;
  }

  Eigen::Isometry3d track(const cameras::StereoFrame& frame) {
    std::vector<uchar> seen_left, seen_right;
    follow(left_, frame.left, corners_, last_left_, seen_left);
    follow(right_, frame.right, in_right_, last_right_, seen_right);
    std::vector<Eigen::Vector3d> from, to;
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      if (!seen_right_[i] || !seen_left[i] || !seen_right[i] ||
          cameras::epipolarError_px(rig_, at(last_left_[i]), at(last_right_[i])) > 1.5)
        continue;
      from.push_back(reference_mm_[i]), to.push_back(triangulated(last_left_[i], last_right_[i]));
    }
    std::vector<double> weights(from.size(), 1.0);
    Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
    for (int round = 0; round < 5 && from.size() >= 4; ++round) {
      motion = fitRigidPoints(from, to, weights).to_T_from;
      for (std::size_t i = 0; i < from.size(); ++i)
        weights[i] = 1.0 / (1.0 + std::min(1e3, (motion * from[i] - to[i]).squaredNorm()));
    }
    return motion;
  }

 private:
  void follow(const cv::Mat& from, const cv::Mat& to, const std::vector<cv::Point2f>& points,
              std::vector<cv::Point2f>& found, std::vector<uchar>& is_found) const {
    if (found.empty()) found = points;
    std::vector<float> errors;
    cv::calcOpticalFlowPyrLK(from, to, points, found, is_found, errors, {15, 15}, 3,
                             {cv::TermCriteria::COUNT | cv::TermCriteria::EPS, 20, 0.01},
                             cv::OPTFLOW_USE_INITIAL_FLOW);
  }
  Eigen::Vector3d triangulated(const cv::Point2f& left, const cv::Point2f& right) const {
    return cameras::triangulate(rig_, at(left), at(right)).mm;
  }
  static Eigen::Vector2d at(const cv::Point2f& px) { return {px.x, px.y}; }

  cameras::StereoRig rig_;
  cv::Mat left_, right_;
  std::vector<cv::Point2f> corners_, in_right_, last_left_, last_right_;
  std::vector<uchar> seen_right_;
  std::vector<Eigen::Vector3d> reference_mm_;
};

using Frames = std::vector<std::pair<support::SyntheticView, cameras::StereoFrame>>;
using Track = std::function<std::optional<Eigen::Isometry3d>(const cameras::StereoFrame&)>;

Result run(const Frames& frames, const Track& track) {
  Result result;
  for (const auto& [view, frame] : frames) {
    const double start_ms = processorTime_ms();
    const auto motion = track(frame);
    result.time_ms.push_back(processorTime_ms() - start_ms);
    if (!motion) {
      ++result.lost;
      continue;
    }
    const auto error = poseError(RigidTransform<Camera, Head>::fromIsometry(*motion),
                                 RigidTransform<Camera, Head>::fromIsometry(view.motion), kCortex);
    result.error_mm.push_back(error.at_point_mm);
    result.rotation_deg.push_back(error.rotation_rad / kRadPerDeg);
  }
  return result;
}

double rms(const std::vector<double>& values) {
  double sum = 0;
  for (double value : values) sum += value * value;
  return values.empty() ? 0.0 : std::sqrt(sum / double(values.size()));
}

void print(const char* motion, const char* method, const Result& result, double own_ms) {
  const double median_ms = support::quantile(result.time_ms, 0.5);
  std::printf("| %s | %s | %.3f | %.3f | %.3f | %.3f | %d | %.2f | %.2f | %.1f |\n", motion, method,
              rms(result.error_mm), support::quantile(result.error_mm, 0.95),
              support::quantile(result.error_mm, 1.0), rms(result.rotation_deg), result.lost, median_ms,
              support::quantile(result.time_ms, 0.99), median_ms / own_ms);
}

Track of(head_tracking::HeadTracker& tracker) {
  return [&tracker](const cameras::StereoFrame& frame) -> std::optional<Eigen::Isometry3d> {
    const auto pose = tracker.track(frame);
    if (!pose) return std::nullopt;
    return pose->camera_T_head.isometry();
  };
}

void compare(const Motion& motion, const support::SyntheticFace& face, const cameras::StereoRig& rig,
             const std::shared_ptr<const face::FaceDetector>& detector) {
  Frames frames;
  for (int i = 0; i < kFrames; ++i) {
    const auto view = viewAt(i, motion.yaw_deg);
    frames.emplace_back(view, face.render(rig, view));
  }
  support::SyntheticView still;
  still.seed = 99;
  const auto reference = face.reference(rig, true, still);
  const auto model = head_tracking::makeModelHeadTracker(detector),
             features = peers::makeFeatureHeadTracker(detector);
  model->start(rig, reference), features->start(rig, reference);
  LucasKanadeTracker lucas_kanade(rig, reference);
  const Result own = run(frames, of(*model));
  const double own_ms = support::quantile(own.time_ms, 0.5);
  print(motion.name, "model", own, own_ms);
  print(motion.name, "features7 (NCC)", run(frames, of(*features)), own_ms);
  print(motion.name, "OpenCV LK + triangulation",
        run(frames, [&](const auto& frame) { return std::optional(lucas_kanade.track(frame)); }), own_ms);
}

void findLost(const support::SyntheticFace& face, const cameras::StereoRig& rig,
              const std::shared_ptr<const face::FaceDetector>& detector) {
  const auto model = head_tracking::makeModelHeadTracker(detector);
  model->start(rig, face.reference(rig, true));
  model->track(face.render(rig, viewAt(0, 10)));
  support::SyntheticView hidden = viewAt(1, 10);
  hidden.cover_mm = cv::Rect2d(-200, -200, 400, 400);
  std::vector<double> lost_ms;
  for (int i = 0; i < 6; ++i) {
    const auto frame = face.render(rig, hidden);
    const double start_ms = processorTime_ms();
    model->track(frame);
    lost_ms.push_back(processorTime_ms() - start_ms);
  }
  const auto frame = face.render(rig, viewAt(20, 10));
  const double detect_ms =
      support::oneCore_ms([&] { detector->detect(frame.left), detector->detect(frame.right); }, 3);
  std::printf("\n| face lost, a frame | median ms | max ms |\n|---|---|---|\n");
  std::printf("| model: own pictures, fits | %.2f | %.2f |\n", support::quantile(lost_ms, 0.5),
              support::quantile(lost_ms, 1.0));
  std::printf("| Haar cascade + landmarks, both images | %.2f | |\n", detect_ms);
}

}  // namespace

int main() {
  cv::setNumThreads(1);
  const OneCoreOnly one_core;
  if (!std::filesystem::exists(support::SyntheticFace::portraitPath())) {
    std::printf("left out: no portrait (python3-skimage)\n");
    return 0;
  }
  const auto rig = support::faceRig();
  const auto face = support::SyntheticFace::astronaut();
  const std::shared_ptr<const face::FaceDetector> detector = face::makeFaceDetector();
  std::printf("# Head tracking, VGA stereo, noise 1.5 grey levels, %d frames at 30 a second, one core\n\n",
              kFrames);
  std::printf(
      "| motion | method | rms mm | p95 mm | max mm | rms deg | lost | median ms | p99 ms | time ratio |\n");
  std::printf("|---|---|---|---|---|---|---|---|---|---|\n");
  for (const Motion& motion : {Motion{"shifts only", 0.0}, Motion{"yaw to 25 deg", 25.0}})
    compare(motion, face, rig, detector), std::fflush(stdout);
  findLost(face, rig, detector);
}
