#pragma once
// An image file as 8-bit grey, damaged files refused.

#include <filesystem>
#include <opencv2/core.hpp>

namespace facenav::capture {

/// True for the extensions of PNG, JPEG, BMP, TIFF and PGM.
bool isImageFile(const std::filesystem::path& path);

/// 1-channel image of 8 or 16 bit as stored; colour converted to grey; no EXIF rotation, since the
/// calibration speaks of pixels as recorded. Throws Error naming the file: missing, truncated, undecodable.
cv::Mat readGrey(const std::filesystem::path& path);

/// The camera's bit depth (8, 10, 12, 14 or 16) as the brightest pixel tells it.
int bitDepth(const cv::Mat& image);

/// 8-bit, 1 channel, of any 8- or 16-bit image of 1, 3 or 4 channels (BGR); 16-bit is scaled from `bits`.
cv::Mat toGrey8(const cv::Mat& image, int bits);

}  // namespace facenav::capture
