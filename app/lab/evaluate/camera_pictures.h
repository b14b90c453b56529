#pragma once
// Photographs of one person (or board) by several calibrated cameras at several moments. Files are named
// <camera>_<moment>.jpg|png, with one letter per camera; <a><b>_stereo.yml beside them is the rig with a on
// the left.

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "facenav/cameras/stereo_frame.h"
#include "facenav/cameras/stereo_rig.h"

namespace facenav::app {

/// Picture files by name: "l_418".
std::map<std::string, std::filesystem::path> picturesIn(const std::filesystem::path& folder);
/// Rigs by name: "lm". Throws Error for a file that is no rig.
std::map<std::string, cameras::StereoRig> rigsIn(const std::filesystem::path& folder);
/// Moments for which both cameras have a file, sorted by name: "418".
std::vector<std::string> momentsOf(const std::map<std::string, std::filesystem::path>& pictures, char left,
                                   char right);
/// Reads a picture as 8-bit grey. Throws Error naming a file that cannot be read.
cv::Mat readGrey(const std::filesystem::path& path);

}  // namespace facenav::app
