#include "picture_intake.h"

#include <algorithm>
#include <cstring>

namespace facenav::capture {
namespace {

// A stamp of the steady clock lies a little before the arrival. One outside this range is not of that clock.
constexpr double kYoungest_s = -0.005, kOldest_s = 1.0;
constexpr double kShortestStep_s = 1e-6;

bool isUniform(const cv::Mat& image) {
  double least = 0, most = 0;
  cv::minMaxLoc(image, &least, &most);
  return least == most;
}

bool isEqual(const cv::Mat& a, const cv::Mat& b) {
  if (a.size() != b.size() || a.empty()) return false;
  for (int row = 0; row < a.rows; ++row)
    if (std::memcmp(a.ptr(row), b.ptr(row), std::size_t(a.cols)) != 0) return false;
  return true;
}

}  // namespace

double PictureIntake::steadyTime(StampClock clock, double stamp_s, double arrival_s) {
  if (clock == StampClock::none) return arrival_s;
  if (clock == StampClock::file) return stamp_s;
  if (clock == StampClock::device) {
    const double mapped_s = clock_.map(stamp_s, arrival_s);
    counts_.clock_steps = clock_.steps();
    return mapped_s;
  }
  const double age_s = arrival_s - stamp_s;
  if (age_s < kYoungest_s || age_s > kOldest_s) {
    ++counts_.clock_steps;
    return arrival_s - last_age_s_;
  }
  last_age_s_ = age_s;
  return stamp_s;
}

/// Number of a picture: increasing, with the driver's gaps. Some drivers number from 0 again, or do not
/// number at all.
std::int64_t PictureIntake::number(std::int64_t sequence) {
  const std::int64_t step = last_sequence_ && sequence > *last_sequence_ ? sequence - *last_sequence_ : 1;
  counts_.dropped += step - 1;
  last_sequence_ = sequence;
  return number_ += step;
}

/// Rejects repeats. The sensor's noise makes two exposures differ; only a covered or overexposed sensor gives
/// equal ones: these are uniform, and count as new.
std::optional<CameraPicture> PictureIntake::accept(cv::Mat grey, std::int64_t sequence, StampClock clock,
                                                   double stamp_s, double arrival_s) {
  if (clock != StampClock::file && isEqual(grey, last_) && !isUniform(grey)) {
    ++counts_.repeated;
    last_sequence_ = std::max(sequence, last_sequence_.value_or(sequence));
    return std::nullopt;
  }
  CameraPicture picture;
  picture.sequence = number(sequence);
  last_s_ = std::max(steadyTime(clock, stamp_s, arrival_s), last_s_ + kShortestStep_s);
  picture.captured = {last_s_};
  picture.grey = last_ = std::move(grey);
  ++counts_.delivered;
  return picture;
}

}  // namespace facenav::capture
