#pragma once
// FaceCloud: the face as dense points, measured with projected dots (paper, sections 3 and 7.1) or on plain
// skin. Data flow: StereoFrame -> rectify -> match, sub-pixel -> triangulate -> cloud.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "facenav/cameras/stereo_frame.h"
#include "facenav/cameras/stereo_rig.h"
#include "facenav/core/task_monitor.h"
#include "facenav/stereo/dense_matcher.h"

namespace facenav::stereo {

/// Options of the "field" matcher for skin under dense dots: more steps, and detail down to creases.
inline MatchOptions skinOptions() {
  MatchOptions options;
  options.steps = 2;
  options.growths = 4;
  options.details = 3;
  options.least_correlation = 0.3;  // largest_sigma_px decides
  options.largest_sigma_px = 0.3;
  return options;
}

/// Options for a quick check now and then (drift watchdog): no detail.
inline MatchOptions quickSkinOptions() {
  MatchOptions options;
  options.steps = 2;
  options.largest_sigma_px = 0.3;
  return options;
}

/// Options for plain skin: a wider window and less detail than with dots.
inline MatchOptions plainSkinOptions() {
  MatchOptions options;
  options.window_sigma_px = 4.0;
  options.steps = 3;
  options.details = 1;
  options.least_correlation = 0.3;  // largest_sigma_px decides
  options.largest_sigma_px = 0.5;
  options.smallest_patch_px = 1000;
  return options;
}

/// Standard deviation of plain skin's disparity, in addition to the match's predicted one. Neighbouring
/// pixels and frames of one face share this error, because skin texture is coarser than the window.
constexpr double kPlainSkinError_px = 0.15;

struct FaceCloudOptions {
  double nearest_mm = 300.0, farthest_mm = 1500.0;  // searched depth range
  std::optional<cv::Rect> left_roi;       // in the left image as recorded; empty for the whole image
  std::string matcher = kDefaultMatcher;  // see dense_matcher.h
  /// Points of a surface known beforehand at its present place, for example the aligned skin at the tracked
  /// pose: at most about 4 px apart in the image, correct to half a pixel of disparity. They replace the
  /// search, which takes two thirds of the time. If the face has moved by more, few points or none are found.
  std::shared_ptr<const PointCloud<Camera>> expected;
  MatchOptions match = skinOptions();  // limits of what is accepted
  /// False: plain skin. "sgm" finds the surface first, and points are off by more than the match predicts.
  /// "field" only.
  bool has_dots = true;
};

/// Options for pictures with dots, matched by `matcher`. "ssd" and "sgm" use the limits of MatchOptions.
inline FaceCloudOptions dottedFaceOptions(const std::string& matcher) {
  FaceCloudOptions options;
  options.matcher = matcher;
  if (matcher != kDefaultMatcher) options.match = MatchOptions();
  return options;
}

/// Options for pictures without dots, in which the settings for dots would take noise for detail.
inline FaceCloudOptions plainFaceOptions() {
  FaceCloudOptions options;
  options.match = plainSkinOptions();
  options.has_dots = false;
  return options;
}

struct FaceCloud {
  PointCloud<Camera> cloud;              // one point per matched left pixel; unit normals towards the camera
  std::vector<Eigen::Vector2f> left_px;  // the pixel of each point in the left image as recorded
  std::vector<float> sigma_mm;           // predicted standard deviation along the ray, one per point
  /// Median row disagreement of the best matches with the calibration; empty if too few matched.
  std::optional<double> epipolar_median_px;
};

/// Measures the scene lit by the dot pattern, or plain skin (`has_dots`). Throws Error if the images are
/// black, of the wrong size, or without texture that matches ("no dots found: ...", "too little texture:
/// ..."), and for a matcher that is unknown or needs dots that are missing.
FaceCloud measureFace(const cameras::StereoRig& rig, const cameras::StereoFrame& frame,
                      const FaceCloudOptions& options, TaskMonitor& monitor);

}  // namespace facenav::stereo
