#include "facenav/capture/calibration_images.h"

#include <glob.h>

#include <algorithm>

#include "facenav/core/error.h"
#include "grey_image.h"
#include "name_number.h"

namespace facenav::capture {
namespace fs = std::filesystem;
namespace {

std::vector<fs::path> expand(const std::vector<std::string>& patterns, const std::string& side) {
  std::vector<fs::path> files;
  for (const auto& pattern : patterns) {
    glob_t found = {};
    const bool has_match = ::glob(pattern.c_str(), GLOB_TILDE, nullptr, &found) == 0;
    for (std::size_t i = 0; has_match && i < found.gl_pathc; ++i) files.emplace_back(found.gl_pathv[i]);
    ::globfree(&found);
    if (!has_match)
      throw Error("no " + side + " image matches", pattern, "check the path, and quote the pattern");
  }
  if (files.empty()) throw Error("there are no " + side + " images", "--" + side);
  std::stable_sort(files.begin(), files.end(), [](const fs::path& a, const fs::path& b) {
    return numberInName(a).value_or(0) < numberInName(b).value_or(0);
  });
  return files;
}

}  // namespace

std::vector<cameras::CalibrationPair> readCalibrationImages(const std::vector<std::string>& left,
                                                            const std::vector<std::string>& right) {
  const auto left_files = expand(left, "left"), right_files = expand(right, "right");
  if (left_files.size() != right_files.size())
    throw Error("left and right counts differ: " + std::to_string(left_files.size()) + " left images, " +
                    std::to_string(right_files.size()) + " right ones",
                left.front() + ", " + right.front(), "each pair needs one image of both sides");
  std::vector<cameras::CalibrationPair> pairs;
  for (std::size_t i = 0; i < left_files.size(); ++i) {
    const std::string name = left_files[i].filename().string() + ", " + right_files[i].filename().string();
    if (numberInName(left_files[i]) != numberInName(right_files[i]))
      throw Error("left and right numbers differ", name, "give both images of a pair the same number");
    const cv::Mat left_image = readGrey(left_files[i]), right_image = readGrey(right_files[i]);
    const int bits = std::max(bitDepth(left_image), bitDepth(right_image));
    pairs.push_back({name, toGrey8(left_image, bits), toGrey8(right_image, bits)});
  }
  return pairs;
}

}  // namespace facenav::capture
