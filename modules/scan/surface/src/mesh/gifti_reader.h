#pragma once
// Reads GIFTI 1.0 (nitrc.org/projects/gifti): the arrays of a file as numbers. gifti_io does not read here:
// it prints lines of its own about a damaged file and takes compressed data that are damaged for zeros.
// Private to surface.

#include <filesystem>
#include <string>
#include <vector>

namespace facenav::surface {

struct GiftiArray {
  std::string intent;                   // such as NIFTI_INTENT_POINTSET
  std::vector<std::string> dataspaces;  // of its coordinate systems
  std::size_t rows = 0, columns = 1;
  std::vector<double> values;  // row by row, whatever the order of the file

  double at(std::size_t row, std::size_t column) const { return values[row * columns + column]; }
};

/// Throws Error if the file or an array of it is damaged, or of a kind that is not known.
std::vector<GiftiArray> readGifti(const std::filesystem::path& path);

}  // namespace facenav::surface
