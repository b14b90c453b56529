#pragma once
// Writes an RgbImage as PNG, completely or not at all (temporary name, then rename).

#include <filesystem>

#include "facenav/core/file_access.h"
#include "facenav/core/rgb_image.h"

namespace facenav::scene {

/// Throws Error if the folder cannot be written to or the image is empty.
void writePng(const RgbImage& image, const std::filesystem::path& path,
              FileAccess access = FileAccess::by_umask);

}  // namespace facenav::scene
