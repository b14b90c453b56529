#pragma once
// Images of local mean 0 and standard deviation 1, as 6 bits: differences of them are blind to gain and
// offset.

#include <opencv2/core.hpp>

namespace facenav::stereo {

constexpr int kNormalisedMiddle = 32, kNormalisedHighest = 63;
constexpr int kNormalisedInvalid = 255;  // differs from all valid ones by the most

/// 8-bit, rows x columns, the image at its top left (mirrored: at its top right, columns from right to left).
/// Where `mask` is 0 and beyond the image: `invalid`. `margin`: columns kept free before it.
cv::Mat normalisedImage(const cv::Mat& image, const cv::Mat& mask, int invalid, int rows, int columns,
                        int margin, bool is_mirrored);

}  // namespace facenav::stereo
