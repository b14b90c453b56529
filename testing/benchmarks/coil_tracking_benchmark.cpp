// The coil's marker tracker and its peers in one run: error against the truth of a ray-cast scene, and the
// time of a tracked frame and of a whole frame (processor time, one core). Peers: cv::aruco with sub-pixel
// corners, its pose by solvePnP IPPE from the left image and by triangulated corners from both images; the
// AprilTag library if it is installed. Prints Markdown tables.
// coil_tracking_benchmark [poses per row, 60]

#ifdef FACENAV_HAS_APRILTAG
#include <apriltag/apriltag.h>
#include <apriltag/tag36h11.h>
#endif

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <opencv2/aruco.hpp>
#include <opencv2/calib3d.hpp>
#include <opencv2/core/utility.hpp>
#include <random>
#include <vector>

#include "facenav/coil_tracking/coil_tracker.h"
#include "facenav/core/parallel_for.h"
#include "facenav/geometry/pose_error.h"
#include "facenav/geometry/rigid_fit.h"
#include "facenav/geometry/rotation.h"
#include "support/stopwatch.h"
#include "unit/track/coil_tracking/coil_scene.h"

using namespace facenav;
using namespace facenav::coil_tracking;
using facenav::testing::quantile;
namespace scene = facenav::coil_tracking::testing;

namespace {

using Pose = RigidTransform<Camera, Marker>;
using Method = std::function<std::optional<Pose>(const cameras::StereoFrame&)>;

double rms(const std::vector<double>& values) {
  double squares = 0;
  for (const double v : values) squares += v * v;
  return std::sqrt(squares / double(std::max<std::size_t>(1, values.size())));
}

struct View {
  cameras::StereoFrame frame;
  Pose truth;
};

struct Conditions {
  const char* name;
  cameras::StereoRig rig;
  double nearest_mm, farthest_mm, most_tilt_deg;
  scene::SceneOptions options;
};

std::vector<View> views(const Conditions& conditions, int count, int dictionary = cv::aruco::DICT_4X4_50) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  std::vector<View> made;
  for (int i = 0; i < count; ++i) {
    const double distance_mm =
        conditions.nearest_mm + part(random) * (conditions.farthest_mm - conditions.nearest_mm);
    const Eigen::Vector2d side_mm(distance_mm * 0.1 * (2 * part(random) - 1),
                                  distance_mm * 0.1 * (2 * part(random) - 1));
    const Pose truth = scene::markerPose(distance_mm, conditions.most_tilt_deg * part(random),
                                         360 * part(random), 360 * part(random), side_mm);
    scene::SceneOptions options = conditions.options;
    options.seed = unsigned(i + 1);
    View view{
        scene::renderMarkers(conditions.rig, {{scene::arucoPrint(dictionary, 7), 60.0, truth}}, options),
        truth};
    view.frame.captured.s = 10.0 * i;  // too long after the last frame to predict from it
    made.push_back(std::move(view));
  }
  return made;
}

/// Pose from the corners in both images: top left, top right, bottom right, bottom left of a print of 60 mm.
std::optional<Pose> poseOf(const cameras::StereoRig& rig, const std::vector<cv::Point2f>& left,
                           const std::vector<cv::Point2f>& right) {
  if (left.empty() || right.empty()) return std::nullopt;
  std::vector<Eigen::Vector3d> from_mm, to_mm;
  for (std::size_t i = 0; i < 4; ++i) {
    from_mm.emplace_back(i == 1 || i == 2 ? 30.0 : -30.0, i < 2 ? -30.0 : 30.0, 0.0);
    to_mm.push_back(cameras::triangulate(rig, {left[i].x, left[i].y}, {right[i].x, right[i].y}).mm);
  }
  return Pose::fromIsometry(fitRigidPoints(from_mm, to_mm).to_T_from);
}

class Aruco {
 public:
  explicit Aruco(const cameras::StereoRig& rig) : rig_(rig) {
    parameters_->cornerRefinementMethod = cv::aruco::CORNER_REFINE_SUBPIX;
  }
  std::optional<Pose> fromLeft(const cameras::StereoFrame& frame) const {
    const auto corners = detect(frame.left);
    if (corners.empty()) return std::nullopt;
    cv::Vec3d rotation, translation;
    cv::solvePnP(model(), corners, rig_.left.k, rig_.left.distortion, rotation, translation, false,
                 cv::SOLVEPNP_IPPE_SQUARE);
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    // IPPE_SQUARE's y axis runs up the print: rotate to the format's axes.
    pose.linear() = expRotation({rotation[0], rotation[1], rotation[2]}) *
                    Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitX()).matrix();
    pose.translation() << translation[0], translation[1], translation[2];
    return Pose::fromIsometry(pose);
  }
  std::optional<Pose> fromBoth(const cameras::StereoFrame& frame) const {
    return poseOf(rig_, detect(frame.left), detect(frame.right));
  }

 private:
  static std::vector<cv::Point3f> model() {
    return {{-30.f, 30.f, 0.f}, {30.f, 30.f, 0.f}, {30.f, -30.f, 0.f}, {-30.f, -30.f, 0.f}};
  }
  std::vector<cv::Point2f> detect(const cv::Mat& grey) const {
    std::vector<std::vector<cv::Point2f>> corners;
    std::vector<int> ids;
    cv::aruco::detectMarkers(grey, dictionary_, corners, ids, parameters_);
    for (std::size_t i = 0; i < ids.size(); ++i)
      if (ids[i] == 7) return corners[i];
    return {};
  }
  const cameras::StereoRig& rig_;
  cv::Ptr<cv::aruco::Dictionary> dictionary_ = cv::aruco::getPredefinedDictionary(cv::aruco::DICT_4X4_50);
  cv::Ptr<cv::aruco::DetectorParameters> parameters_ = cv::aruco::DetectorParameters::create();
};

#ifdef FACENAV_HAS_APRILTAG
/// The AprilTag library on a print of its own family, with default settings except full resolution.
class AprilTag {
 public:
  explicit AprilTag(const cameras::StereoRig& rig) : rig_(rig) {
    apriltag_detector_add_family(detector_, family_);
    detector_->quad_decimate = 1.0f;  // half resolution, its default, makes corners less exact
    detector_->nthreads = 1;
  }
  ~AprilTag() {
    apriltag_detector_destroy(detector_);
    tag36h11_destroy(family_);
  }
  AprilTag(const AprilTag&) = delete;
  AprilTag& operator=(const AprilTag&) = delete;
  std::optional<Pose> fromBoth(const cameras::StereoFrame& frame) const {
    return poseOf(rig_, detect(frame.left), detect(frame.right));
  }

 private:
  std::vector<cv::Point2f> detect(const cv::Mat& grey) const {
    image_u8_t image{grey.cols, grey.rows, int(grey.step), grey.data};
    zarray_t* found = apriltag_detector_detect(detector_, &image);
    std::vector<cv::Point2f> corners;
    for (int i = 0; i < zarray_size(found); ++i) {
      apriltag_detection_t* tag = nullptr;
      zarray_get(found, i, &tag);
      if (tag->id != 7) continue;
      // Its corners run counter-clockwise, its print is upside down compared with OpenCV's, and pixel centres
      // are at .5.
      for (const int corner : {1, 0, 3, 2})
        corners.emplace_back(float(tag->p[corner][0] - 0.5), float(tag->p[corner][1] - 0.5));
      break;
    }
    apriltag_detections_destroy(found);
    return corners;
  }
  const cameras::StereoRig& rig_;
  apriltag_family_t* family_ = tag36h11_create();
  apriltag_detector_t* detector_ = apriltag_detector_create();
};
#endif

struct Figures {
  std::vector<double> translation_mm, rotation_deg, time_ms;
  int lost = 0, wrong = 0;
};

Figures measure(const std::vector<View>& views, const Method& method) {
  Figures figures;
  for (const View& view : views) {
    const double start = processorTime_ms();
    const auto pose = method(view.frame);
    figures.time_ms.push_back(processorTime_ms() - start);
    if (!pose) {
      ++figures.lost;
      continue;
    }
    const PoseError error = poseError(*pose, view.truth);
    figures.translation_mm.push_back(error.translation_mm);
    figures.rotation_deg.push_back(error.rotation_rad * 180 / M_PI);
    figures.wrong += error.translation_mm > 3.0 || error.rotation_rad > 2.0 * M_PI / 180;
  }
  return figures;
}

void printRow(const char* conditions, const char* method, const Figures& f) {
  std::printf("| %s | %s | %.3f | %.3f | %.3f | %.3f | %d | %d | %.2f | %.2f |\n", conditions, method,
              rms(f.translation_mm), quantile(f.translation_mm, 1.0), rms(f.rotation_deg),
              quantile(f.rotation_deg, 1.0), f.lost, f.wrong, quantile(f.time_ms, 0.5),
              quantile(f.time_ms, 0.99));
}

/// Two frames per pose: the marker is found in the first and tracked in the second (1 mm further).
Figures tracked(const Conditions& conditions, const std::vector<View>& found, double& stated_ratio) {
  const auto tracker = makeMarkerCoilTracker();
  tracker->start(conditions.rig, defaultCoil());
  Figures figures;
  double squares = 0;
  int count = 0;
  for (const View& view : found) {
    if (!tracker->track(view.frame)) continue;
    cameras::StereoFrame next = view.frame;
    next.captured.s += 0.01;
    const double start = processorTime_ms();
    const auto pose = tracker->track(next);
    figures.time_ms.push_back(processorTime_ms() - start);
    if (!pose) {
      ++figures.lost;
      continue;
    }
    const PoseError error = poseError(pose->camera_T_marker, view.truth);
    figures.translation_mm.push_back(error.translation_mm);
    figures.rotation_deg.push_back(error.rotation_rad * 180 / M_PI);
    figures.wrong += error.translation_mm > 3.0 || error.rotation_rad > 2.0 * M_PI / 180;
    squares += error.translation_mm * error.translation_mm / pose->covariance.diagonal().tail<3>().sum();
    ++count;
  }
  stated_ratio = std::sqrt(squares / std::max(1, count));
  return figures;
}

void compare(const Conditions& conditions, int count) {
  const auto found = views(conditions, count);
  const Aruco aruco(conditions.rig);
  const auto whole = makeMarkerCoilTracker();
  whole->start(conditions.rig, defaultCoil());
  printRow(conditions.name, "FaceNav, whole frame",
           measure(found, [&](const cameras::StereoFrame& frame) -> std::optional<Pose> {
             const auto pose = whole->track(frame);
             if (!pose) return std::nullopt;
             return pose->camera_T_marker;
           }));
  double stated_ratio = 0;
  const Figures followed = tracked(conditions, found, stated_ratio);
  char name[64];
  std::snprintf(name, sizeof name, "FaceNav, tracked (error / stated %.2f)", stated_ratio);
  printRow(conditions.name, name, followed);
  printRow(conditions.name, "aruco, left, IPPE",
           measure(found, [&](const auto& f) { return aruco.fromLeft(f); }));
  printRow(conditions.name, "aruco, both, triangulated",
           measure(found, [&](const auto& f) { return aruco.fromBoth(f); }));
#ifdef FACENAV_HAS_APRILTAG
  const AprilTag april(conditions.rig);
  printRow(conditions.name, "AprilTag 36h11 at the same places, both, triangulated",
           measure(views(conditions, count, cv::aruco::DICT_APRILTAG_36h11),
                   [&](const auto& f) { return april.fromBoth(f); }));
#endif
}

/// Prints the cost of frames without the marker.
void printLost(const cameras::StereoRig& rig, int count) {
  const auto tracker = makeMarkerCoilTracker();
  tracker->start(rig, defaultCoil());
  const Aruco aruco(rig);
  std::vector<double> ours_ms, peer_ms;
  for (int i = 0; i < count; ++i) {
    scene::SceneOptions options;
    options.seed = unsigned(i + 1);
    const auto frame = scene::renderMarkers(rig, {}, options);
    double start = processorTime_ms();
    if (tracker->track(frame)) std::printf("found a marker where there is none\n");
    ours_ms.push_back(processorTime_ms() - start);
    start = processorTime_ms();
    if (aruco.fromBoth(frame)) std::printf("aruco found a marker where there is none\n");
    peer_ms.push_back(processorTime_ms() - start);
  }
  std::printf("\nNo marker in the clutter: FaceNav %.2f ms (p99 %.2f), aruco %.2f ms (p99 %.2f)\n",
              quantile(ours_ms, 0.5), quantile(ours_ms, 0.99), quantile(peer_ms, 0.5),
              quantile(peer_ms, 0.99));
}

}  // namespace

int main(int argc, char** argv) {
  cv::setNumThreads(1);
  const OneCoreOnly one_core;
  const int count = argc > 1 ? std::atoi(argv[1]) : 60;
  scene::SceneOptions usual, soft, dim;
  soft.gamma = 0.45;
  soft.blur_sigma_px = 1.3;
  dim.white_grey = 48;
  dim.black_grey = 12;
  dim.ground_grey = 20;
  std::printf("| scene | method | rms mm | max mm | rms deg | max deg | lost | wrong | ms | ms p99 |\n");
  std::printf("|---|---|---|---|---|---|---|---|---|---|\n");
  compare({"400-700 mm, to 50 deg", scene::roomRig(), 400, 700, 50, usual}, count);
  compare({"850-900 mm, to 60 deg", scene::roomRig(), 850, 900, 60, usual}, count);
  compare({"gamma 0.45, blur 1.3 px", scene::roomRig(), 450, 700, 50, soft}, count);
  compare({"dim light", scene::roomRig(), 450, 700, 50, dim}, count);
  compare({"1000 x 750, cameras stacked", scene::steepRig(), 450, 900, 50, usual}, count);
  printLost(scene::roomRig(), count);
  return 0;
}
