#pragma once
// Clocks of an XDF recording: a stream's own clock as the recorder's, and the times of samples at a regular
// rate without the jitter of their stamps.

#include <optional>
#include <vector>

#include "xdf/xdf_file.h"

namespace facenav::steps {

/// Maps a stream's clock to the recorder's by lines through its measured offsets, one from each reset of the
/// clock to the next. Without offsets both clocks are the same.
class XdfClock {
 public:
  explicit XdfClock(const std::vector<XdfClockOffset>& offsets);
  double recorded_s(double stamp_s) const { return stamp_s + offset_s(stamp_s); }
  double offset_s(double stamp_s) const;

 private:
  struct Line {
    double from_s, to_s, middle_s, offset_s, slope;
  };
  std::vector<Line> lines_;
};

/// Times of a series on the recorder's clock: straight lines between breaks.
class XdfTimes {
 public:
  XdfTimes(const XdfSeries& series, double rate_hz, const XdfClock& clock);
  /// Indices [first, last) of the samples in the interval; nothing where a break or the end lies in it.
  std::optional<std::pair<std::uint64_t, std::uint64_t>> within(double from_s, double to_s) const;

 private:
  struct Piece {
    std::uint64_t first, last;  // indices [first, last)
    double start_s, step_s;     // time of the first, and between samples
  };
  std::vector<Piece> pieces_;
};

}  // namespace facenav::steps
