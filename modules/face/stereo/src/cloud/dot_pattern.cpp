#include "facenav/stereo/dot_pattern.h"

#include "facenav/core/error.h"

namespace facenav::stereo {
namespace {

// SplitMix64 (Steele, Lea, Flood 2014) gives the same dots on every platform; std::uniform_int_distribution
// does not.
std::uint64_t nextRandom(std::uint64_t& state) {
  std::uint64_t z = (state += 0x9E3779B97F4A7C15u);
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
  return z ^ (z >> 31);
}

constexpr int kDot_px = 2;

}  // namespace

cv::Mat makeDotPattern(DotPattern kind, std::uint64_t seed, int width, int height) {
  FACENAV_EXPECT(width >= kDot_px && height >= kDot_px, "the pattern must hold a dot");
  const int block_px = kind == DotPattern::sparse ? 64 : 6;
  cv::Mat pattern = cv::Mat::zeros(height, width, CV_8U);
  std::uint64_t state = seed;
  for (int top = 0; top < height; top += block_px)
    for (int left = 0; left < width; left += block_px) {
      const int x = left + int(nextRandom(state) % (block_px - kDot_px + 1));
      const int y = top + int(nextRandom(state) % (block_px - kDot_px + 1));
      pattern(cv::Rect(x, y, kDot_px, kDot_px) & cv::Rect(0, 0, width, height)) = 255;
    }
  return pattern;
}

}  // namespace facenav::stereo
