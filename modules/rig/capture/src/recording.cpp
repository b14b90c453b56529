#include "facenav/capture/recording.h"

#include <algorithm>
#include <cmath>

#include "facenav/core/error.h"
#include "facenav/core/log.h"
#include "grey_image.h"
#include "recording_frames.h"

namespace facenav::capture {
namespace fs = std::filesystem;
namespace {

constexpr double kAssumedRate_hz = 60.0;
constexpr double kMostApart_s = 1.0;  // largest time between the two pictures of a pair

struct StampedFrame {
  std::int64_t number;
  double t_s;
  std::optional<double> right_late_s;
};

/// Delay from the column right_t_s, which may be absent or empty.
std::optional<double> rightLate(const CsvTable& table, std::size_t row, double t_s) {
  const auto column = table.findColumn("right_t_s");
  if (!column || table.text(row, *column).empty()) return std::nullopt;
  const double late_s = table.number(row, *column) - t_s;
  if (std::abs(late_s) > kMostApart_s)
    table.refuse(row, "right_t_s is far from t_s", "both are seconds of one clock");
  return late_s;
}

std::vector<StampedFrame> readTimestamps(const fs::path& csv) {
  const CsvTable table(csv, kTypedByHand);
  const std::size_t frame = table.column("frame"), time = table.column("t_s");
  std::vector<StampedFrame> stamps;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const double number = table.number(i, frame), t_s = table.number(i, time);
    if (number != std::floor(number) || std::abs(number) > 1e15) table.refuse(i, "frame is no whole number");
    if (!stamps.empty() && !(t_s > stamps.back().t_s))
      table.refuse(i, "time does not rise", "t_s must grow from line to line");
    if (!stamps.empty() && !(std::int64_t(number) > stamps.back().number))
      table.refuse(i, "frame number does not rise");
    stamps.push_back({std::int64_t(number), t_s, rightLate(table, i, t_s)});
  }
  return stamps;
}

// Assigns times: matches by frame number if every image has a line. Otherwise matches by order if both have
// the same count (file names that start at another index); the frame then gets the number in the CSV, which
// the truth files use.
void applyTimestamps(const fs::path& csv, const std::vector<StampedFrame>& stamps, RecordingFrames& frames) {
  const std::vector<std::int64_t>& images = frames.pairs->numbers();
  std::size_t at = 0;
  for (const std::int64_t number : images) {
    while (at < stamps.size() && stamps[at].number < number) ++at;
    if (at == stamps.size() || stamps[at].number != number) break;
    frames.numbers.push_back(number);
    frames.times_s.push_back(stamps[at].t_s);
    frames.right_late_s.push_back(stamps[at].right_late_s);
  }
  if (frames.numbers.size() == images.size()) return;
  if (stamps.size() != images.size())
    throw Error("has " + std::to_string(stamps.size()) + " lines, but the recording " +
                    std::to_string(images.size()) + " frames (frame " +
                    std::to_string(images[frames.numbers.size()]) + " has no line)",
                csv.string(), "each frame needs its line");
  frames.numbers.clear();
  frames.times_s.clear();
  frames.right_late_s.clear();
  for (const auto& stamp : stamps) {
    frames.numbers.push_back(stamp.number);
    frames.times_s.push_back(stamp.t_s);
    frames.right_late_s.push_back(stamp.right_late_s);
  }
}

std::optional<fs::path> stillIn(const fs::path& folder, const std::string& name) {
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().stem() == name && isImageFile(entry.path())) return entry.path();
  return std::nullopt;
}

fs::path findStill(const fs::path& folder, const std::string& name) {
  if (const auto path = stillIn(folder, name)) return *path;
  throw Error(
      "image '" + name + ".png' is missing", folder.string(),
      "capture/ needs plain_left and plain_right, and with a projector pattern_left and pattern_right");
}

cameras::StereoFrame readStill(const fs::path& folder, const std::string& kind,
                               const cameras::StereoRig& rig) {
  const fs::path left_path = findStill(folder, kind + "_left"),
                 right_path = findStill(folder, kind + "_right");
  const cv::Mat left = readGrey(left_path), right = readGrey(right_path);
  requireRigSize(rig, left, right, left_path.string());
  const int bits = std::max(bitDepth(left), bitDepth(right));
  cameras::StereoFrame frame;
  frame.left = toGrey8(left, bits);
  frame.right = toGrey8(right, bits);
  return frame;
}

/// Reads the capture. Without pictures with dots, the plain pair is used for both.
CapturePair readCapture(const fs::path& folder, const cameras::StereoRig& rig) {
  CapturePair capture;
  capture.plain = readStill(folder, "plain", rig);
  const bool has_pattern = stillIn(folder, "pattern_left") || stillIn(folder, "pattern_right");
  capture.pattern = has_pattern ? readStill(folder, "pattern", rig) : capture.plain;
  return capture;
}

void refuseEmpty(const fs::path& folder) {
  std::error_code ignored;
  if (fs::is_empty(folder, ignored))
    throw Error("the recording's folder is empty", folder.string(), "choose another recording");
}

Recording openFolder(const fs::path& folder) {
  if (!fs::exists(folder)) throw Error("recording does not exist", folder.string(), "check the path");
  if (!fs::is_directory(folder)) throw Error("is no folder", folder.string(), "give the recording's folder");
  refuseEmpty(folder);
  Recording recording;
  recording.folder = folder;
  recording.rig = cameras::readRig(folder / "stereo.yml");
  if (fs::is_directory(folder / "capture"))
    recording.capture = readCapture(folder / "capture", recording.rig);
  return recording;
}

// Checks the frames, then closes them; makeSource opens them again at little cost.
void describeFrames(Recording& recording, RecordingFrames& frames) {
  recording.frame_count = std::int64_t(frames.numbers.size());
  recording.has_timestamps = frames.has_timestamps;
  if (recording.frame_count == 0) return;
  if (frames.has_timestamps && recording.frame_count > 1)
    recording.frames_per_s =
        double(recording.frame_count - 1) / (frames.times_s.back() - frames.times_s.front());
  if (!frames.has_timestamps)
    logWarning("no timestamps.csv in " + recording.folder.string() + ": 60 frames per second are assumed");
  const auto first = frames.pairs->next();
  if (first) requireRigSize(recording.rig, first->left, first->right, first->where);
}

}  // namespace

void requireRigSize(const cameras::StereoRig& rig, const cv::Mat& left, const cv::Mat& right,
                    const std::string& where) {
  for (const cv::Mat& image : {left, right})
    if (image.cols != rig.width_px || image.rows != rig.height_px)
      throw Error("image is " + std::to_string(image.cols) + " x " + std::to_string(image.rows) +
                      ", but stereo.yml is for " + std::to_string(rig.width_px) + " x " +
                      std::to_string(rig.height_px),
                  where, "use the stereo.yml of these cameras");
}

RecordingFrames openFrames(const fs::path& folder) {
  const fs::path csv = folder / "timestamps.csv";
  RecordingFrames frames;
  frames.has_timestamps = fs::exists(csv);
  const auto stamps = frames.has_timestamps ? readTimestamps(csv) : std::vector<StampedFrame>{};
  frames.pairs = openImagePairs(folder);
  const auto expected = frames.has_timestamps ? std::optional<std::size_t>(stamps.size()) : std::nullopt;
  if (!frames.pairs) frames.pairs = openVideoPairs(folder, expected);
  if (!frames.pairs || frames.pairs->numbers().empty()) return frames;
  if (frames.has_timestamps) {
    applyTimestamps(csv, stamps, frames);
    return frames;
  }
  frames.numbers = frames.pairs->numbers();
  for (const std::int64_t number : frames.numbers)
    frames.times_s.push_back(double(number - frames.numbers.front()) / kAssumedRate_hz);
  frames.right_late_s.assign(frames.times_s.size(), std::nullopt);
  return frames;
}

void requireFrames(const RecordingFrames& frames, const fs::path& folder) {
  std::error_code ignored;
  if (!fs::exists(folder, ignored))
    throw Error("the recording's folder is missing", folder.string(),
                "connect its disk or open another recording");
  refuseEmpty(folder);
  if (!frames.pairs)
    throw Error("has neither left/ and right/ nor left.mkv and right.mkv", folder.string(),
                "is it a recording? see resources/doc/formats.md");
  if (frames.numbers.empty()) throw Error("the recording holds 0 frames", folder.string(), "record it again");
}

Recording openRecording(const fs::path& folder) {
  Recording recording = openFolder(folder);
  RecordingFrames frames = openFrames(folder);
  requireFrames(frames, folder);
  describeFrames(recording, frames);
  return recording;
}

Recording openCapture(const fs::path& folder) {
  Recording recording = openFolder(folder);
  RecordingFrames frames = openFrames(folder);
  describeFrames(recording, frames);
  return recording;
}

}  // namespace facenav::capture
