#pragma once
// The face as dense points: what the capture pair with projected dots gives (paper, sections 3 and 7.1).
// Data flow: StereoFrame (dots) -> rectify -> 11 x 11 matching, sub-pixel, left-right check -> triangulate ->
// cloud.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "facenav/cameras/stereo_frame.h"
#include "facenav/cameras/stereo_rig.h"
#include "facenav/core/task_monitor.h"
#include "facenav/stereo/dense_matcher.h"

namespace facenav::stereo {

/// Of the "field" matcher for skin under dense dots: more steps, and detail down to creases.
inline MatchOptions skinOptions() {
  MatchOptions options;
  options.steps = 2;
  options.growths = 4;
  options.details = 3;
  options.least_correlation = 0.3;  // sigma decides
  options.largest_sigma_px = 0.3;
  return options;
}

/// For a quick check now and then (drift watchdog): no detail.
inline MatchOptions quickSkinOptions() {
  MatchOptions options;
  options.steps = 2;
  options.largest_sigma_px = 0.3;
  return options;
}

/// For plain skin: a wider window and less detail than with dots. Of the settings tried, those with which two
/// camera pairs agree best about one real face.
inline MatchOptions plainSkinOptions() {
  MatchOptions options;
  options.window_sigma_px = 4.0;
  options.steps = 3;
  options.details = 1;
  options.least_correlation = 0.3;  // sigma decides
  options.largest_sigma_px = 0.5;
  options.smallest_patch_px = 1000;
  return options;
}

/// Error of plain skin's disparity, one standard deviation, beside what the match predicts. Skin texture is
/// coarser than the window, so that neighbouring pixels, and frames of one face, share this error. Fitted on
/// one rendered face of known shape and one real face seen by two camera pairs.
constexpr double kPlainSkinError_px = 0.15;

struct FaceCloudOptions {
  double nearest_mm = 300.0, farthest_mm = 1500.0;  // depth range searched
  std::optional<cv::Rect> left_roi;                 // in the left image as recorded; empty: the whole image
  std::string matcher = kDefaultMatcher;            // see dense_matcher.h
  /// Points of a surface known beforehand, as it lies now: say, the aligned skin at the tracked pose. No
  /// farther apart than about 4 px in the image, and right to half a pixel of disparity. Nothing is searched
  /// then, which costs a third of the time. Where the face has moved by more, few points or none are found.
  std::shared_ptr<const PointCloud<Camera>> expected;
  MatchOptions match = skinOptions();  // limits of what is accepted
  /// False: plain skin. "sgm" finds the surface first, and points are off by more than the match predicts.
  /// "field" and "field_cuda" only.
  bool has_dots = true;
};

/// For pictures with dots, matched by `matcher`. "ssd" and "sgm" take the limits of MatchOptions.
inline FaceCloudOptions dottedFaceOptions(const std::string& matcher) {
  FaceCloudOptions options;
  options.matcher = matcher;
  if (matcher.rfind("field", 0) != 0) options.match = MatchOptions();
  return options;
}

/// For pictures without dots: settings made for dots take noise for detail there.
inline FaceCloudOptions plainFaceOptions() {
  FaceCloudOptions options;
  options.match = plainSkinOptions();
  options.has_dots = false;
  return options;
}

struct FaceCloud {
  PointCloud<Camera> cloud;              // one point per matched left pixel; normals unit, towards the camera
  std::vector<Eigen::Vector2f> left_px;  // the pixel of each point in the left image as recorded
  std::vector<float> sigma_mm;           // predicted standard deviation along the ray, one per point
  /// Row disagreement of the best matches with the calibration; nothing where too few matched.
  std::optional<double> epipolar_median_px;
};

/// Measures the scene lit by the dot pattern, or plain skin (`has_dots`). Throws Error when the images are
/// black, of the wrong size, or hold no texture that matches ("no dots found: ...", "too little texture:
/// ..."), and for a matcher that is unknown or needs dots where there are none.
FaceCloud measureFace(const cameras::StereoRig& rig, const cameras::StereoFrame& frame,
                      const FaceCloudOptions& options, TaskMonitor& monitor);

}  // namespace facenav::stereo
