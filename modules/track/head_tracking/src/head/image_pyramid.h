#pragma once
// ImagePyramid: one image blurred by the binomial kernel 1 4 6 4 1 (sigma 1 px: less noise, and less bias of
// bilinear sampling), and its halves. 16 bits contain the kernel's sums without rounding: 256 per grey level.
// Pixel x of level l lies at 2^l x of the image. For a tracked head only its box of level 0 is made. For a
// search, all coarser levels are made, and only a box of level 0.

#include <array>
#include <opencv2/core.hpp>

namespace facenav::head_tracking {

constexpr int kLevels = 4;
constexpr int kCoarsestStep = 1 << (kLevels - 1);  // pixels of the image per pixel of the coarsest level
constexpr float kGreyScale = 256.f;                // units of the blurred images per grey level
constexpr int kBlurMargin_px = 2;                  // pixels at the image's edge without a blurred value

/// Part of a level: pixels(0, 0) is the level's pixel `origin`.
struct BlurredImage {
  cv::Mat1w pixels;
  cv::Point origin;
};

/// Level 0 inside `box`, cut to where the kernel fits; may be empty. `grey`: 8-bit, 1 channel.
BlurredImage blurredPart(const cv::Mat& grey, const cv::Rect& box);

struct ImagePyramid {
  std::array<BlurredImage, kLevels> level;

  ImagePyramid() = default;
  /// All levels of the whole image; the outermost pixels repeat their neighbours. `origin`: position of this
  /// image in a larger one, multiples of kCoarsestStep.
  explicit ImagePyramid(const cv::Mat& grey, cv::Point origin = {});
  /// Makes all levels but level 0, in a third of the time.
  static ImagePyramid coarse(const cv::Mat& grey, cv::Point origin = {});
};

/// A level as float, in grey levels.
cv::Mat1f greyOf(const BlurredImage& image);

}  // namespace facenav::head_tracking
