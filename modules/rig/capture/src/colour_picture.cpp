#include "facenav/capture/colour_picture.h"

#include <algorithm>
#include <opencv2/imgcodecs.hpp>

#include "facenav/core/error.h"
#include "grey_image.h"
#include "name_number.h"
#include "recording_frames.h"

namespace facenav::capture {
namespace fs = std::filesystem;
namespace {

bool isColoured(const cv::Mat& image) {
  if (image.type() != CV_8UC3) return false;
  std::vector<cv::Mat> planes;
  cv::split(image, planes);
  return cv::norm(planes[0], planes[1], cv::NORM_INF) > 0 || cv::norm(planes[0], planes[2], cv::NORM_INF) > 0;
}

// Reads a picture in colour, oriented as by readGrey(): the EXIF rotation is ignored.
cv::Mat readColour(const fs::path& path, const cameras::StereoRig& rig) {
  const cv::Mat image = cv::imread(path.string(), cv::IMREAD_COLOR | cv::IMREAD_IGNORE_ORIENTATION);
  const bool has_rig_size = image.cols == rig.width_px && image.rows == rig.height_px;
  return has_rig_size && isColoured(image) ? image : cv::Mat();
}

template <class Matches>
cv::Mat firstIn(const fs::path& folder, const cameras::StereoRig& rig, Matches&& matches) {
  if (!fs::is_directory(folder)) return {};
  for (const auto& entry : fs::directory_iterator(folder))
    if (isImageFile(entry.path()) && matches(entry.path())) return readColour(entry.path(), rig);
  return {};
}

}  // namespace

cv::Mat leftColour(const Recording& recording, std::int64_t frame) {
  const RecordingFrames frames = openFrames(recording.folder);
  const auto found = std::find(frames.numbers.begin(), frames.numbers.end(), frame);
  if (!frames.pairs || found == frames.numbers.end())
    throw Error("has no frame " + std::to_string(frame), recording.folder.string());
  // timestamps.csv may number the frames differently from the files.
  const std::int64_t in_name = frames.pairs->numbers()[std::size_t(found - frames.numbers.begin())];
  return firstIn(recording.folder / "left", recording.rig,
                 [&](const fs::path& path) { return numberInName(path) == in_name; });
}

cv::Mat captureColour(const Recording& recording) {
  return firstIn(recording.folder / "capture", recording.rig,
                 [](const fs::path& path) { return path.stem() == "plain_left"; });
}

}  // namespace facenav::capture
