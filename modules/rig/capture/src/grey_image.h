#pragma once
// Reads an image file as 8-bit grey and refuses damaged files.

#include <filesystem>
#include <opencv2/core.hpp>

namespace facenav::capture {

/// True for the extensions of PNG, JPEG, BMP, TIFF and PGM.
bool isImageFile(const std::filesystem::path& path);

/// Reads a 1-channel image of 8 or 16 bit as stored; colour is converted to grey. No EXIF rotation, since the
/// calibration refers to pixels as recorded. Throws Error naming the file: missing, truncated, undecodable.
cv::Mat readGrey(const std::filesystem::path& path);

/// The camera's bit depth (8, 10, 12, 14 or 16), estimated from the brightest pixel.
int bitDepth(const cv::Mat& image);

/// Converts any 8- or 16-bit image of 1, 3 or 4 channels (BGR) to 8-bit, 1 channel; `bits` is the bit depth
/// of a 16-bit image.
cv::Mat toGrey8(const cv::Mat& image, int bits);

}  // namespace facenav::capture
