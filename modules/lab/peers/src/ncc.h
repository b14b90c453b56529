#pragma once
// Normalised cross-correlation (paper, equations 3-5): the score of a template in an image and its sub-pixel
// peak.

#include <Eigen/Core>
#include <opencv2/core.hpp>
#include <optional>

namespace facenav::peers {

/// Normalised cross-correlation: equation 3 with the means of equations 4 and 5 subtracted. -1..1 for two
/// 8-bit patches of one size; 0 if one of them is flat.
double ncc(const cv::Mat& image, const cv::Mat& templ);

struct NccPeak {
  Eigen::Vector2d px;  // place of the template's centre
  double ncc = 0.0;
};

/// The best position of `templ` (odd width and height) with its centre within `radius_px` of `guess_px`,
/// sub-pixel by a paraboloid through the 3 x 3 scores round the peak. Returns nothing if the peak lies on the
/// border of the searched area (it may be higher outside) or too near the image's edge.
std::optional<NccPeak> findPeak(const cv::Mat& image, const cv::Mat& templ, const Eigen::Vector2d& guess_px,
                                int radius_px);

}  // namespace facenav::peers
