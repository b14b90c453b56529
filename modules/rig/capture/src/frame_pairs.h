#pragma once
// FramePairs: the image pairs of a recording in order, from folders or from videos.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <vector>

namespace facenav::capture {

struct ImagePair {
  cv::Mat left, right;  // 8-bit grey
  std::string where;    // file, or video and frame, for error messages
};

class FramePairs {
 public:
  virtual ~FramePairs() = default;
  /// Frame number of each pair, increasing.
  virtual const std::vector<std::int64_t>& numbers() const = 0;
  /// The next pair; nullopt at the end. Throws Error naming the file.
  virtual std::optional<ImagePair> next() = 0;
  /// Moves to the pair at `index` of numbers(), which next() then returns. Images: at once; a video is read
  /// up to there.
  virtual void goTo(std::size_t index) = 0;
};

/// Opens left/ and right/ with images. Null if neither folder exists. Throws Error: one side missing, counts
/// or numbers differ, two files with one number.
std::unique_ptr<FramePairs> openImagePairs(const std::filesystem::path& folder);

/// Opens left.mkv and right.mkv (or .avi, .mp4, .mov, .webm). Null if neither exists. Throws Error: one side
/// missing, cannot be decoded, counts differ. `expected_count`: number of rows of timestamps.csv, which
/// avoids counting the frames.
std::unique_ptr<FramePairs> openVideoPairs(const std::filesystem::path& folder,
                                           std::optional<std::size_t> expected_count);

}  // namespace facenav::capture
