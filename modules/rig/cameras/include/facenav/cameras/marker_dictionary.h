#pragma once
// The names of OpenCV's predefined ArUco dictionaries, as resources/doc/formats.md writes them: 4x4_50 ..
// 7x7_1000, aruco_original, apriltag_16h5 .. apriltag_36h11 (with or without a leading "DICT_", in any case).

#include <string>

namespace facenav::cameras {

/// The number of cv::aruco::PREDEFINED_DICTIONARY_NAME. Throws Error that lists the known names for an
/// unknown one.
int predefinedDictionary(const std::string& name);

}  // namespace facenav::cameras
