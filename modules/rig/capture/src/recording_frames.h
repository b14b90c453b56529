#pragma once
// The frames of a recording folder with their numbers and times. openRecording checks them and the source
// plays them.

#include <memory>
#include <optional>
#include <vector>

#include "facenav/capture/recording.h"
#include "facenav/core/csv_table.h"
#include "frame_pairs.h"

namespace facenav::capture {

/// timestamps.csv and truth files may come from other tools or be typed by hand.
constexpr CsvRules kTypedByHand{true, true};

struct RecordingFrames {
  std::unique_ptr<FramePairs> pairs;  // null: the folder has neither image folders nor videos
  std::vector<std::int64_t> numbers;
  std::vector<double> times_s;
  std::vector<std::optional<double>> right_late_s;  // as many as times_s
  bool has_timestamps = false;
};

/// Opens the frames. Throws the same Errors as openRecording.
RecordingFrames openFrames(const std::filesystem::path& folder);

/// Throws Error with the reason why there are no frames: the folder is missing or empty, it is no recording,
/// or it has 0 frames.
void requireFrames(const RecordingFrames& frames, const std::filesystem::path& folder);

/// Throws Error that names `where`, unless both images have the rig's size.
void requireRigSize(const cameras::StereoRig& rig, const cv::Mat& left, const cv::Mat& right,
                    const std::string& where);

}  // namespace facenav::capture
