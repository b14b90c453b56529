#include <algorithm>

#include "facenav/core/error.h"
#include "facenav/core/log.h"
#include "frame_pairs.h"
#include "grey_image.h"
#include "numbered_images.h"

namespace facenav::capture {
namespace fs = std::filesystem;
namespace {

// Throws Error if the numbers differ: pairing by order could combine images of different moments.
void requireSameNumbers(const fs::path& folder, const std::vector<NumberedImage>& left,
                        const std::vector<NumberedImage>& right) {
  if (left.size() != right.size())
    throw Error("left and right counts differ: " + std::to_string(left.size()) + " images in left/, " +
                    std::to_string(right.size()) + " in right/",
                folder.string(), "each frame needs one image on both sides");
  for (std::size_t i = 0; i < left.size(); ++i)
    if (left[i].number != right[i].number)
      throw Error("left and right frame numbers differ: " + left[i].path.filename().string() +
                      " stands beside " + right[i].path.filename().string(),
                  folder.string(), "give both images of a pair the same number");
}

class ImagePairs : public FramePairs {
 public:
  ImagePairs(std::vector<NumberedImage> left, std::vector<NumberedImage> right)
      : left_(std::move(left)), right_(std::move(right)) {
    for (const auto& image : left_) numbers_.push_back(image.number);
  }
  const std::vector<std::int64_t>& numbers() const override { return numbers_; }
  std::optional<ImagePair> next() override {
    if (at_ >= left_.size()) return std::nullopt;
    const fs::path &left = left_[at_].path, &right = right_[at_].path;
    const cv::Mat left_image = readGrey(left), right_image = readGrey(right);
    // Uses one depth for the whole recording: a scale that changes between frames would look like flicker.
    if (bits_ == 0) bits_ = std::max(bitDepth(left_image), bitDepth(right_image));
    if (at_ == 0 && bits_ > 8)
      logInfo("images of " + std::to_string(bits_) + " bits are converted to 8: " + left.string());
    ++at_;
    return ImagePair{toGrey8(left_image, bits_), toGrey8(right_image, bits_), left.string()};
  }
  void goTo(std::size_t index) override { at_ = index; }

 private:
  std::vector<NumberedImage> left_, right_;
  std::vector<std::int64_t> numbers_;
  std::size_t at_ = 0;
  int bits_ = 0;
};

}  // namespace

std::unique_ptr<FramePairs> openImagePairs(const fs::path& folder) {
  const bool has_left = fs::is_directory(folder / "left"), has_right = fs::is_directory(folder / "right");
  if (!has_left && !has_right) return nullptr;
  if (has_left != has_right)
    throw Error(std::string("folder '") + (has_left ? "right" : "left") + "' is missing", folder.string(),
                "a recording has left/ and right/");
  auto left = listImages(folder / "left"), right = listImages(folder / "right");
  requireSameNumbers(folder, left, right);
  return std::make_unique<ImagePairs>(std::move(left), std::move(right));
}

}  // namespace facenav::capture
