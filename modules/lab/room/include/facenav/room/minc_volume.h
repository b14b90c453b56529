#pragma once
// A MINC volume in the format of npm's brainbrowser: a JSON header (`order` from the slowest to the fastest
// axis; start, space_length, step and direction_cosines per axis) and raw 8-bit voxels, both gzipped. World p
// = sum over the axes of (start + index * step) * direction_cosines, x right, y anterior, z superior: RAS mm,
// that is Mri.

#include <filesystem>

#include "facenav/volume/volume.h"

namespace facenav::room {

/// Reads the volume. Throws Error naming the file and the key if the header lacks a key or the voxels do not
/// fill the grid.
volume::Volume readMincVolume(const std::filesystem::path& header_json_gz,
                              const std::filesystem::path& raw_gz);

}  // namespace facenav::room
