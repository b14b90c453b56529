#pragma once
// Normalises images to local mean 0 and standard deviation 1, as 6 bits. Differences are then independent of
// gain and offset.

#include <opencv2/core.hpp>

namespace facenav::stereo {

constexpr int kNormalisedMiddle = 32, kNormalisedHighest = 63;
constexpr int kNormalisedInvalid = 255;  // largest difference to every valid level

/// 8-bit, rows x columns, the image at its top left (mirrored: at its top right, columns from right to left).
/// `invalid` outside the mask and beyond the image. `margin`: free columns before it.
cv::Mat normalisedImage(const cv::Mat& image, const cv::Mat& mask, int invalid, int rows, int columns,
                        int margin, bool is_mirrored);

}  // namespace facenav::stereo
