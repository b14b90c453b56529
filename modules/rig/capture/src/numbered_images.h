#pragma once
// The pictures of a folder in the order of the numbers in their names.

#include <cstdint>
#include <filesystem>
#include <vector>

namespace facenav::capture {

struct NumberedImage {
  std::int64_t number;
  std::filesystem::path path;
};

/// Lists the pictures of a folder by their numbers. Throws Error: a name without a number, a number that
/// comes twice.
std::vector<NumberedImage> listImages(const std::filesystem::path& folder);

}  // namespace facenav::capture
