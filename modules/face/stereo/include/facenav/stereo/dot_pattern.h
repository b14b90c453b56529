#pragma once
// DotPattern: the image that the projector shows. Sparse: the paper's (section 7.1: 1024 x 768, one 2 x 2 dot
// at random in each 64 x 64 block). Dense: more dots, since 11 x 11 windows mostly miss such sparse ones.

#include <cstdint>
#include <opencv2/core.hpp>

namespace facenav::stereo {

enum class DotPattern {
  sparse,
  dense
};  // sparse: the paper's 16 x 12 blocks; dense: a dot in each 6 x 6 block

/// 8-bit, 1 channel, height x width: white dots (255) on black. Deterministic in `seed`.
cv::Mat makeDotPattern(DotPattern kind, std::uint64_t seed, int width = 1024, int height = 768);

}  // namespace facenav::stereo
