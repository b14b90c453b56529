#include "facenav/stereo/face_cloud.h"

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>

#include "cloud/epipolar_check.h"
#include "cloud_normals.h"
#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "facenav/stereo/dense_matcher.h"
#include "matchers/block_search.h"

namespace facenav::stereo {
namespace {

constexpr std::size_t kFewestPoints = 500;
constexpr double kSuspicious_px = 0.12;  // row disagreement; 0.02 .. 0.05 px fit the calibration
constexpr double kBlack_grey = 6.0;      // least level of the brightest percent; below: no light

double brightLevel(const cv::Mat& image) {
  int histogram[256] = {};
  for (int y = 0; y < image.rows; ++y)
    for (int x = 0; x < image.cols; ++x) ++histogram[image.at<std::uint8_t>(y, x)];
  int above = 0, level = 255;
  for (; level > 0 && (above += histogram[level]) < int(image.total()) / 100; --level) {
  }
  return level;
}

void requireUsable(const cameras::StereoRig& rig, const cameras::StereoFrame& frame) {
  for (const auto& [side, image] : {std::pair("left", &frame.left), std::pair("right", &frame.right)}) {
    if (image->empty())
      throw Error(std::string("there is no ") + side + " image", {}, "record the pair again");
    if (image->type() != CV_8U) throw Error(std::string("the ") + side + " image is not 8-bit grey");
    if (image->cols != rig.width_px || image->rows != rig.height_px)
      throw Error(std::string("the ") + side + " image is " + std::to_string(image->cols) + " x " +
                      std::to_string(image->rows) + ", but the rig's images are " +
                      std::to_string(rig.width_px) + " x " + std::to_string(rig.height_px),
                  {}, "use the stereo.yml of these cameras");
    if (brightLevel(*image) < kBlack_grey)
      throw Error(std::string("the ") + side + " image is black", {}, "check lens cap, exposure and cable");
  }
}

FaceCloud toCloud(const Rectification& rectification, const DisparityMap& map, const cv::Mat& normals,
                  double beside_px) {
  FaceCloud face;
  for (int y = 0; y < map.disparity_px.rows; ++y)
    for (int x = 0; x < map.disparity_px.cols; ++x) {
      const float d = map.disparity_px.at<float>(y, x);
      const cv::Vec3f n = normals.at<cv::Vec3f>(y, x);
      if (std::isnan(d) || std::isnan(n[0])) continue;
      const Eigen::Vector3d p_mm = rectification.point_mm(x, y, d);
      const double z_mm = (rectification.rectified_R_camera * p_mm).z();
      const double per_px_mm = std::abs(rectification.depthPerDisparity_mm(d)) * p_mm.norm() / z_mm;
      const cv::Vec2f pixel = rectification.left_map.at<cv::Vec2f>(y, x);
      face.cloud.points_mm.push_back(p_mm);
      face.cloud.normals.push_back(rectification.rectified_R_camera.transpose() *
                                   Eigen::Vector3d(n[0], n[1], n[2]));
      face.left_px.emplace_back(pixel[0], pixel[1]);
      face.sigma_mm.push_back(float(per_px_mm * std::hypot(map.sigma_px.at<float>(y, x), beside_px)));
    }
  return face;
}

// Finds the surface of plain skin over the whole picture, to about a pixel. Plain skin has too little texture
// for a search block by block.
PointCloud<Camera> roughSurface(const Rectification& rectification, const RectifiedPair& pair) {
  MatchOptions whole;
  whole.largest_sigma_px = 2.0;  // also keeps filled holes
  const cv::Mat disparity = makeDenseMatcher("sgm")->match(rectification, pair, whole).disparity_px;
  PointCloud<Camera> rough;
  for (int y = 0; y < disparity.rows; ++y)
    for (int x = 0; x < disparity.cols; ++x)
      if (const float d = disparity.at<float>(y, x); !std::isnan(d))
        rough.points_mm.push_back(rectification.point_mm(x, y, d));
  return rough;
}

FaceCloud measureOnce(const cameras::StereoRig& rig, const cameras::StereoFrame& frame,
                      const FaceCloudOptions& options, TaskMonitor& monitor) {
  const auto matcher = makeDenseMatcher(options.matcher);
  if (!matcher->startsFromPrediction() && (options.expected || !options.has_dots))
    throw Error("the matcher '" + options.matcher + "' needs projected dots", {},
                std::string("use the matcher '") + kDefaultMatcher + "' for plain skin");
  monitor.report("rectify", 0.0);
  const Rectification rectification =
      rectify(rig, {options.nearest_mm, options.farthest_mm}, options.left_roi.value_or(cv::Rect()));
  const RectifiedPair pair = applyRectification(rectification, frame);
  monitor.report("match", 0.2);
  MatchOptions match = options.match;
  if (options.expected)
    match.predicted_px = blocksOf(rectification, pair.left.size(), *options.expected);
  else if (!options.has_dots)
    match.predicted_px = blocksOf(rectification, pair.left.size(), roughSurface(rectification, pair));
  const DisparityMap map = matcher->match(rectification, pair, match);
  monitor.report("triangulate", 0.9);
  FaceCloud face = toCloud(rectification, map, diskNormals(rectification, map),
                           options.has_dots ? 0.0 : kPlainSkinError_px);
  face.epipolar_median_px = epipolarMedian(rectification, pair, map);
  monitor.report("triangulate", 1.0);
  return face;
}

// Row disagreement; 0 if too few matched.
double rowError_px(const FaceCloud& face) { return face.epipolar_median_px.value_or(0.0); }

// Refuses exchanged images. Those of a converging pair match in places, at plausible depths, and turn the
// face inside out. Their rows disagree a little; exchanged back, the images match far better.
void refuseSwapped(const cameras::StereoRig& rig, const cameras::StereoFrame& frame,
                   const FaceCloudOptions& options, const FaceCloud& face, TaskMonitor& monitor) {
  cameras::StereoFrame swapped = frame;
  std::swap(swapped.left, swapped.right);
  const FaceCloud other = measureOnce(rig, swapped, options, monitor);
  if (other.cloud.size() > kFewestPoints && other.cloud.size() > face.cloud.size() &&
      rowError_px(other) < 0.5 * std::max(rowError_px(face), kSuspicious_px))
    throw Error("left and right images look swapped", {}, "exchange the cameras or the files");
}

}  // namespace

FaceCloud measureFace(const cameras::StereoRig& rig, const cameras::StereoFrame& frame,
                      const FaceCloudOptions& options, TaskMonitor& monitor) {
  requireUsable(rig, frame);
  FaceCloud face = measureOnce(rig, frame, options, monitor);
  const bool is_too_few = face.cloud.size() < kFewestPoints;
  if (is_too_few || rowError_px(face) > kSuspicious_px) refuseSwapped(rig, frame, options, face, monitor);
  if (is_too_few) {
    const double rows = bestRowShift(rig, frame, options);
    if (rows != 0)
      throw Error(
          formatted("the images disagree with the calibration by %.1f px across the rows", std::abs(rows)),
          {}, "the cameras have moved: calibrate again");
    throw Error((options.has_dots ? "no dots found: only " : "too little texture: only ") +
                    std::to_string(face.cloud.size()) + " points match in both images",
                {},
                options.has_dots ? "check projector, exposure, depth range and calibration"
                                 : "check light, focus, depth range and calibration");
  }
  return face;
}

}  // namespace facenav::stereo
