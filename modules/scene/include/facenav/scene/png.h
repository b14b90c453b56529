#pragma once
// Pictures to disk: RgbImage -> PNG, whole file (temporary name, then renamed).

#include <filesystem>

#include "facenav/core/file_access.h"
#include "facenav/core/rgb_image.h"

namespace facenav::scene {

/// Throws Error when the folder cannot be written to or the image is empty.
void writePng(const RgbImage& image, const std::filesystem::path& path,
              FileAccess access = FileAccess::by_umask);

}  // namespace facenav::scene
