#pragma once
// The frames of a recording folder with their numbers and times: what openRecording checks and the source
// plays.

#include <memory>
#include <vector>

#include "facenav/capture/recording.h"
#include "facenav/core/csv_table.h"
#include "frame_pairs.h"

namespace facenav::capture {

/// Other tools and people write timestamps.csv and truth files.
constexpr CsvRules kTypedByHand{true, true};

struct RecordingFrames {
  std::unique_ptr<FramePairs> pairs;  // null: the folder holds neither image folders nor videos
  std::vector<std::int64_t> numbers;
  std::vector<double> times_s;
  bool has_timestamps = false;
};

/// Throws Error as openRecording does.
RecordingFrames openFrames(const std::filesystem::path& folder);

/// Throws Error, naming `where`, unless both images have the rig's size.
void requireRigSize(const cameras::StereoRig& rig, const cv::Mat& left, const cv::Mat& right,
                    const std::string& where);

}  // namespace facenav::capture
