#pragma once
// PictureMatcher: pairs the pictures of two cameras by capture time. Two cameras without a trigger run free:
// their exposures differ by a delay that is constant for minutes (and drifts with their clocks). A left
// picture is paired with the right one that is nearest to its own time plus that delay; a picture whose
// partner was dropped is left out. The delay is kept within 0.6 of a picture's interval, so that pairs do not
// alternate between two partners when the delay is half an interval.

#include <cstdint>
#include <deque>
#include <optional>

#include "facenav/capture/camera.h"

namespace facenav::capture {

struct PicturePair {
  CameraPicture left, right;
  double right_late_s() const { return right.captured - left.captured; }
};

struct PairTiming {
  std::int64_t pairs = 0;
  std::int64_t left_alone = 0, right_alone = 0;  // pictures without a partner
  double right_late_s = 0.0;                     // median over the last pairs
  double spread_s = 0.0;                         // median absolute deviation from it
};

class PictureMatcher {
 public:
  /// `interval_s`: expected time between two pictures of a camera; it is measured from then on.
  explicit PictureMatcher(double interval_s);
  /// Adds pictures of one side, in the order of their times. At most 8 a side wait for a partner; older ones
  /// are left out.
  void addLeft(CameraPicture picture);
  void addRight(CameraPicture picture);
  /// Oldest complete pair; nullopt if there is none. Does not wait: a partner that is nearer cannot come
  /// later.
  std::optional<PicturePair> take();
  PairTiming timing() const;

 private:
  struct Side {
    std::deque<CameraPicture> waiting;
    std::deque<double> intervals_s;
    double last_s = -1e300;
    std::int64_t alone = 0;
    void add(CameraPicture picture);
    void dropFront();
    std::optional<double> interval_s() const;
  };
  double interval_s() const;
  void follow(double delay_s);

  Side left_, right_;
  double expected_interval_s_, delay_s_ = 0.0;
  bool has_delay_ = false;
  std::deque<double> delays_s_;
  std::int64_t pairs_ = 0;
};

}  // namespace facenav::capture
