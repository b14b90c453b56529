#pragma once
// Two files or folders of pictures as a pair of cameras.

#include "facenav/capture/camera_pair_source.h"

namespace facenav::capture {

/// Reads both files picture by picture and pairs them by their time stamps, each counted from its file's
/// first picture. No picture is skipped, however slowly next() is called; a frame's number is that of its
/// left picture in the file. Pictures without a partner are left out and named by cautions(). next() returns
/// pairs no faster than they were taken.
std::unique_ptr<CameraPairSource> openFilePair(const cameras::StereoRig& rig, std::unique_ptr<Camera> left,
                                               std::unique_ptr<Camera> right, const PairSettings& settings);

}  // namespace facenav::capture
