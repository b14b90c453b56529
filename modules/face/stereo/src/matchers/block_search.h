#pragma once
// Stage 1 of the "field" matcher: the surface within about half a pixel, from windows of 12 x 12 pixels
// around each 4 x 4 block.

#include <opencv2/core.hpp>

#include "facenav/stereo/rectification.h"
#include "kernels/block_kernel.h"

namespace facenav::stereo {

/// One disparity for each 4 x 4 pixels of the rectified left image, 32-bit float. Blocks without a clear
/// match are filled from their neighbours. All NaN if nothing matches.
cv::Mat searchBlocks(const Rectification& rectification, const RectifiedPair& pair,
                     const block::Kernel& kernel = block::kernel());

/// Disparities of a known surface's points (Camera) instead of a search: the nearest point in each block.
cv::Mat blocksOf(const Rectification& rectification, const cv::Size& image,
                 const PointCloud<Camera>& surface);

/// Number of blocks with a clear match that agrees with their neighbours.
int matchedBlocks(const Rectification& rectification, const RectifiedPair& pair);

}  // namespace facenav::stereo
