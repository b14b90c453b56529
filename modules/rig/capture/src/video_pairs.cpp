#include <cstdlib>
#include <numeric>
#include <opencv2/core/utils/logger.hpp>
#include <opencv2/videoio.hpp>

#include "facenav/core/error.h"
#include "frame_pairs.h"
#include "grey_image.h"

namespace facenav::capture {
namespace fs = std::filesystem;
namespace {

std::optional<fs::path> findVideo(const fs::path& folder, const std::string& side) {
  for (const char* extension : {".mkv", ".avi", ".mp4", ".mov", ".webm"})
    if (fs::exists(folder / (side + extension))) return folder / (side + extension);
  return std::nullopt;
}

cv::VideoCapture openVideo(const fs::path& path) {
  // FFmpeg and OpenCV print messages about damaged files to stderr; only our own line should appear.
  static const bool is_ffmpeg_quiet = ::setenv("OPENCV_FFMPEG_LOGLEVEL", "-8", 0) == 0;
  (void)is_ffmpeg_quiet;
  const auto level = cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
  cv::VideoCapture video(path.string());
  cv::utils::logging::setLogLevel(level);
  if (!video.isOpened())
    throw Error("video cannot be opened", path.string(), "is it whole, and its codec installed?");
  return video;
}

std::size_t countFrames(const fs::path& path) {
  cv::VideoCapture video = openVideo(path);
  std::size_t count = 0;
  while (video.grab()) ++count;
  return count;
}

// Count on which both containers and timestamps.csv agree. A container's frame count is often an estimate, so
// it is used only if all three sources agree.
std::size_t agreedCount(const fs::path& left, const fs::path& right, std::optional<std::size_t> expected) {
  const auto stated = [](const fs::path& path) { return openVideo(path).get(cv::CAP_PROP_FRAME_COUNT); };
  if (expected && stated(left) == double(*expected) && stated(right) == double(*expected)) return *expected;
  const std::size_t left_count = countFrames(left), right_count = countFrames(right);
  if (left_count != right_count)
    throw Error("left and right counts differ: " + std::to_string(left_count) + " frames in " +
                    left.filename().string() + ", " + std::to_string(right_count) + " in " +
                    right.filename().string(),
                left.parent_path().string(), "both videos must hold the same frames");
  return left_count;
}

class VideoPairs : public FramePairs {
 public:
  VideoPairs(const fs::path& left, const fs::path& right, std::size_t count)
      : left_path_(left),
        right_path_(right),
        left_(openVideo(left)),
        right_(openVideo(right)),
        numbers_(count) {
    std::iota(numbers_.begin(), numbers_.end(), 0);
  }
  const std::vector<std::int64_t>& numbers() const override { return numbers_; }
  std::optional<ImagePair> next() override {
    if (at_ >= numbers_.size()) return std::nullopt;
    const std::string where = left_path_.string() + ", frame " + std::to_string(at_);
    ++at_;
    return ImagePair{read(left_, left_path_), read(right_, right_path_), where};
  }
  /// Reads frame by frame: a container's own index is often wrong by some frames.
  void goTo(std::size_t index) override {
    if (index < at_) {
      left_ = openVideo(left_path_);
      right_ = openVideo(right_path_);
      at_ = 0;
    }
    for (; at_ < index; ++at_)
      if (!left_.grab() || !right_.grab())
        throw Error("video ends or is damaged at frame " + std::to_string(at_) + " of " +
                        std::to_string(numbers_.size()),
                    left_path_.string(), "copy or record it again");
  }

 private:
  cv::Mat read(cv::VideoCapture& video, const fs::path& path) const {
    cv::Mat image;
    if (!video.read(image) || image.empty())
      throw Error("video ends or is damaged at frame " + std::to_string(at_ - 1) + " of " +
                      std::to_string(numbers_.size()),
                  path.string(), "copy or record it again");
    // Cloned, since the decoder reuses its buffer.
    return toGrey8(image, 16).clone();
  }

  fs::path left_path_, right_path_;
  cv::VideoCapture left_, right_;
  std::vector<std::int64_t> numbers_;
  std::size_t at_ = 0;
};

}  // namespace

std::unique_ptr<FramePairs> openVideoPairs(const fs::path& folder,
                                           std::optional<std::size_t> expected_count) {
  const auto left = findVideo(folder, "left"), right = findVideo(folder, "right");
  if (!left && !right) return nullptr;
  if (!left || !right)
    throw Error(std::string("the ") + (left ? "right" : "left") + " video is missing", folder.string(),
                "a recording has left.mkv and right.mkv");
  return std::make_unique<VideoPairs>(*left, *right, agreedCount(*left, *right, expected_count));
}

}  // namespace facenav::capture
