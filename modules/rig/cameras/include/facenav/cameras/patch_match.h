#pragma once
// patch_match: finds a patch of the left image in the right one, to about a tenth of a pixel in both
// directions: Lucas-Kanade with gain and offset, from a position known to some pixels. Unlike the dense
// matcher it does not use the epipolar line, so it can check that line.

#include <Eigen/Core>
#include <opencv2/core.hpp>
#include <optional>

namespace facenav::cameras {

struct PatchMatch {
  Eigen::Vector2d right_px;
  double correlation = 0;  // normalised correlation of the final patches
  double sigma_px = 0;     // error of the position in its worse direction, from texture and residual
};

/// Matches a patch of 8-bit grey images. nullopt if the patch lacks texture in one direction, leaves the
/// image, moves more than 8 px, or ends with a correlation below 0.85.
std::optional<PatchMatch> matchPatch(const cv::Mat& left, const cv::Mat& right,
                                     const Eigen::Vector2d& left_px, const Eigen::Vector2d& right_start_px);

}  // namespace facenav::cameras
