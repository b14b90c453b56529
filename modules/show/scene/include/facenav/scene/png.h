#pragma once
// Writes an RgbImage as PNG: into a file, completely or not at all (temporary name, then rename), or into
// memory.

#include <cstdint>
#include <filesystem>
#include <vector>

#include "facenav/core/file_access.h"
#include "facenav/core/rgb_image.h"

namespace facenav::scene {

/// Writes the file. Throws Error if the folder cannot be written to or the image is empty.
void writePng(const RgbImage& image, const std::filesystem::path& path,
              FileAccess access = FileAccess::owner_only);
/// Returns the bytes of such a file.
std::vector<std::uint8_t> pngOf(const RgbImage& image);

}  // namespace facenav::scene
