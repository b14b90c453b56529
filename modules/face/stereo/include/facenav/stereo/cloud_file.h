#pragma once
// A FaceCloud as a PLY file (ASCII), for other programs: x y z nx ny nz red green blue sigma_mm frames;
// Camera frame, mm.

#include <filesystem>
#include <string>

#include "facenav/stereo/cloud_fusion.h"

namespace facenav::stereo {

/// `left`: the left picture as recorded, 8-bit, 1 channel (grey in all three colours) or 3 (blue, green,
/// red).
std::string plyText(const FusedCloud& cloud, const cv::Mat& left);

}  // namespace facenav::stereo
