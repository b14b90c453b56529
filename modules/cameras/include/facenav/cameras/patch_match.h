#pragma once
// patch_match: where a patch of the left image lies in the right one, to about a tenth of a pixel in both
// directions: Lucas-Kanade with gain and offset, from a place known to some pixels. Unlike the dense matcher
// it does not trust the epipolar line, so that it can tell whether the line is right.

#include <Eigen/Core>
#include <opencv2/core.hpp>
#include <optional>

namespace facenav::cameras {

struct PatchMatch {
  Eigen::Vector2d right_px;
  double correlation = 0;  // normalised, of the patches at the end
  double sigma_px = 0;     // of the place, the worse direction, from texture and residual
};

/// 8-bit grey images. Nothing where the patch has no texture in both directions, leaves the image, runs more
/// than 8 px away, or does not look alike in the end (correlation below 0.85).
std::optional<PatchMatch> matchPatch(const cv::Mat& left, const cv::Mat& right,
                                     const Eigen::Vector2d& left_px, const Eigen::Vector2d& right_start_px);

}  // namespace facenav::cameras
