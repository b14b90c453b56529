#include "facenav/measured_face/measured_face.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "averaged_pair.h"
#include "facenav/cameras/reduced_pair.h"
#include "facenav/core/error.h"
#include "facenav/measured_face/plain_skin.h"

namespace facenav::measured_face {
namespace {

[[noreturn]] void refuseEmpty() {
  throw Error("no point of a face was measured", {},
              "turn the face towards both cameras, or choose another frame");
}

std::shared_ptr<const cameras::StereoFrame> frameOf(capture::FrameSource& film, std::int64_t number) {
  while (auto frame = film.next())
    if (frame->number == number) return frame;
  const auto count = film.frameCount();
  throw Error("the film has no frame " + std::to_string(number), {},
              count ? "it has " + std::to_string(*count) + " frames, look into timestamps.csv"
                    : "look into timestamps.csv");
}

/// The first frame's face, moved to its position in the current frame.
FaceInSpace moved(const FaceInSpace& first, const Eigen::Isometry3d& now_T_first) {
  FaceInSpace now;
  if (first.centre) now.centre = Point<Camera>(Eigen::Vector3d(now_T_first * first.centre->mm));
  return now;
}

/// Returns false if the frame shows too little to measure.
bool addFrame(const cameras::StereoRig& rig, const cameras::StereoFrame& frame, const FaceInSpace& first,
              const Eigen::Isometry3d& now_T_first, stereo::CloudFusion& fusion) {
  TaskMonitor silent;
  try {
    fusion.add(measureNear(rig, frame, false, moved(first, now_T_first), silent), now_T_first.inverse());
    return true;
  } catch (const Error&) {
    return false;
  }
}

/// Puts the average's points in place of those that it measures too. `frames`: number of its pictures.
void replacePoints(stereo::FusedCloud& cloud, const stereo::FaceCloud& average, int frames) {
  const auto pixelOf = [](const Eigen::Vector2f& px) {
    return std::pair{int(std::lround(px.x())), int(std::lround(px.y()))};
  };
  std::set<std::pair<int, int>> measured;
  for (const auto& px : average.left_px) measured.insert(pixelOf(px));
  stereo::FusedCloud out{average, std::vector<int>(average.cloud.size(), frames)};
  for (std::size_t i = 0; i < cloud.face.cloud.size(); ++i) {
    if (measured.count(pixelOf(cloud.face.left_px[i]))) continue;
    out.face.cloud.points_mm.push_back(cloud.face.cloud.points_mm[i]);
    out.face.cloud.normals.push_back(cloud.face.cloud.normals[i]);
    out.face.left_px.push_back(cloud.face.left_px[i]);
    out.face.sigma_mm.push_back(cloud.face.sigma_mm[i]);
    out.frames.push_back(cloud.frames[i]);
  }
  cloud = std::move(out);
}

/// Averages the frames on the surface that their clouds gave, and measures the average.
void measureAverage(const cameras::StereoRig& rig, const AveragedPair& average, const FaceInSpace& landmarks,
                    stereo::FusedCloud& cloud) {
  if (average.frames() < 2 || cloud.face.cloud.empty()) return;
  TaskMonitor silent;
  try {
    replacePoints(cloud, measureNear(rig, average.averaged(cloud.face.cloud), false, landmarks, silent),
                  int(average.frames()));
  } catch (const Error&) {
    // The average shows too little: the mean of the clouds stays.
  }
}

}  // namespace

MeasuredFace measurePair(const cameras::StereoRig& rig, const cameras::StereoFrame& measured,
                         const cameras::StereoFrame& plain, bool has_dots, const face::FaceDetector& detector,
                         TaskMonitor& monitor) {
  MeasuredFace result;
  result.landmarks = findFace(rig, plain, detector);
  result.first = std::make_shared<const cameras::StereoFrame>(plain);
  const int times = has_dots ? 1 : plainReduction(rig, result.landmarks);
  result.cloud.face = measureNear(cameras::reduced(rig, times), cameras::reduced(measured, times), has_dots,
                                  result.landmarks, monitor);
  toWholePicture(result.cloud.face, times);
  if (result.cloud.face.cloud.empty()) refuseEmpty();
  result.cloud.frames.assign(result.cloud.face.cloud.size(), 1);
  return result;
}

MeasuredFace measureFilm(capture::FrameSource& film, std::int64_t first, std::int64_t last,
                         const FaceMotion& motion, const face::FaceDetector& detector, TaskMonitor& monitor,
                         int most) {
  const cameras::StereoRig& rig = film.rig();
  MeasuredFace result;
  result.first = frameOf(film, first);
  result.landmarks = findFace(rig, *result.first, detector);
  motion(*result.first);
  const int times = plainReduction(rig, result.landmarks);
  const cameras::StereoRig small = cameras::reduced(rig, times);
  stereo::CloudFusion fusion(small, stereo::kPlainSkinError_px);
  fusion.add(measureNear(small, cameras::reduced(*result.first, times), false, result.landmarks, monitor),
             Eigen::Isometry3d::Identity());
  AveragedPair average(small);
  average.add(cameras::reduced(*result.first, times), Eigen::Isometry3d::Identity());
  const std::int64_t step = std::min(last - first, film.frameCount().value_or(last - first)) / most + 1;
  std::int64_t at = 0;
  for (auto frame = film.next(); frame && frame->number <= last; frame = film.next()) {
    monitor.report("frames", double(frame->number - first) / double(last - first));
    const auto camera_T_head = motion(*frame);
    if (camera_T_head) average.add(cameras::reduced(*frame, times), camera_T_head->isometry());
    if (camera_T_head && ++at % step != 0) continue;  // tracked but not measured
    const bool is_added = camera_T_head && addFrame(small, cameras::reduced(*frame, times), result.landmarks,
                                                    camera_T_head->isometry(), fusion);
    ++(is_added ? result.fused : result.lost);
  }
  result.cloud = fusion.fused();
  measureAverage(small, average, result.landmarks, result.cloud);
  toWholePicture(result.cloud.face, times);
  if (result.cloud.face.cloud.empty()) refuseEmpty();
  return result;
}

}  // namespace facenav::measured_face
