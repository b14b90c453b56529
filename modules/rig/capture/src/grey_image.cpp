#include "grey_image.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "facenav/core/error.h"
#include "facenav/core/whole_file.h"

namespace facenav::capture {
namespace {

bool startsWith(const std::string& bytes, const std::string& magic) {
  return bytes.compare(0, magic.size(), magic) == 0;
}

bool isFilm(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  static const std::array<std::string, 8> known = {".mkv",  ".avi", ".mp4", ".mov",
                                                   ".webm", ".m4v", ".mpg", ".mpeg"};
  return std::find(known.begin(), known.end(), extension) != known.end();
}

// Checks for the end marker, because decoders report success for a truncated file and fill the missing part
// with grey or black.
bool isTruncated(const std::string& bytes) {
  const std::string tail = bytes.substr(bytes.size() - std::min<std::size_t>(bytes.size(), 4096));
  if (startsWith(bytes, "\x89PNG")) return tail.find("IEND") == std::string::npos;
  if (startsWith(bytes, "\xFF\xD8")) return tail.rfind("\xFF\xD9") == std::string::npos;
  return false;
}

}  // namespace

bool isImageFile(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  static const std::array<std::string, 7> known = {".png", ".jpg", ".jpeg", ".bmp", ".tif", ".tiff", ".pgm"};
  return std::find(known.begin(), known.end(), extension) != known.end();
}

cv::Mat readGrey(const std::filesystem::path& path) {
  const std::string bytes = readWholeFile(path);
  if (bytes.empty()) throw Error("image file is empty", path.string(), "record it again");
  if (isTruncated(bytes)) throw Error("image file is truncated", path.string(), "copy or record it again");
  cv::Mat image;
  try {
    const cv::Mat buffer(1, int(bytes.size()), CV_8U, const_cast<char*>(bytes.data()));
    image = cv::imdecode(buffer, cv::IMREAD_GRAYSCALE | cv::IMREAD_ANYDEPTH | cv::IMREAD_IGNORE_ORIENTATION);
  } catch (const cv::Exception&) {
    image.release();
  }
  if (image.empty() && isFilm(path))
    throw Error("this is a film, not a picture", path.string(),
                "give pictures; a film of the board goes to 'facenav rig new' as --left-camera or "
                "--right-camera");
  if (image.empty())
    throw Error("image cannot be decoded", path.string(), "save it as PNG, JPEG, BMP or TIFF");
  if (image.depth() != CV_8U && image.depth() != CV_16U)
    throw Error("image has neither 8 nor 16 bits", path.string(), "save it with 8 bits");
  return image;
}

int bitDepth(const cv::Mat& image) {
  if (image.depth() == CV_8U) return 8;
  double brightest = 0;
  cv::minMaxLoc(image.reshape(1), nullptr, &brightest);
  for (int bits : {10, 12, 14})
    if (brightest < double(1 << bits)) return bits;
  return 16;
}

cv::Mat toGrey8(const cv::Mat& image, int bits) {
  cv::Mat grey = image, grey8;
  if (image.channels() == 3) cv::cvtColor(image, grey, cv::COLOR_BGR2GRAY);
  if (image.channels() == 4) cv::cvtColor(image, grey, cv::COLOR_BGRA2GRAY);
  if (grey.depth() == CV_8U) return grey;
  grey.convertTo(grey8, CV_8U, 255.0 / double((1 << bits) - 1));
  return grey8;
}

}  // namespace facenav::capture
