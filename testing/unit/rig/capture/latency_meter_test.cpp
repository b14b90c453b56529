// The latency of a simulated screen and camera, whose delays are known.

#include "facenav/capture/latency_meter.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "facenav/core/error.h"

namespace facenav::capture {
namespace {

/// Screen that shows a change 22 ms late, and a camera at 60 pictures a second: 8 ms exposure, 12 ms
/// transport. The field fills a part of the picture; elsewhere is noise.
class SimulatedRoom {
 public:
  explicit SimulatedRoom(LatencyMeter& meter, double field_grey = 200)
      : meter_(meter), field_grey_(field_grey) {}
  void run() {
    const double interval_s = 1 / 60.0;
    for (int picture = 0; picture < 6000 && !meter_.isDone(); ++picture) {
      const double begin_s = picture * interval_s, arrived_s = begin_s + 0.008 + 0.012;
      while (meter_.nextChange_s() <= arrived_s) {
        const double at_s = std::max(meter_.nextChange_s(), shown_s_.empty() ? 0.0 : shown_s_.back());
        shown_s_.push_back(at_s);
        meter_.shown(at_s);
      }
      meter_.add(photograph(begin_s), begin_s, arrived_s);
    }
  }

 private:
  /// Share of the exposure in which the screen was lit.
  double litShare(double begin_s) const {
    double lit_s = 0;
    for (int i = 0; i < 16; ++i) {
      const double t = begin_s + 0.008 * (i + 0.5) / 16 - 0.022;
      const auto changes = std::upper_bound(shown_s_.begin(), shown_s_.end(), t) - shown_s_.begin();
      lit_s += changes % 2 == 1;
    }
    return lit_s / 16;
  }
  cv::Mat photograph(double begin_s) {
    cv::Mat grey(120, 160, CV_8U);
    random_.fill(grey, cv::RNG::UNIFORM, 90, 110);
    grey(cv::Rect(50, 40, 50, 40)).setTo(20 + field_grey_ * litShare(begin_s));
    return grey;
  }

  LatencyMeter& meter_;
  double field_grey_;
  std::vector<double> shown_s_;
  cv::RNG random_{3};
};

TEST(LatencyMeter, FindsTheKnownDelays) {
  LatencyMeter meter(80);
  SimulatedRoom(meter).run();
  const auto result = meter.result();
  EXPECT_GE(result.changes, 78);
  EXPECT_EQ(result.missed, 0);
  // A picture shows a change if half of its exposure is lit. It begins 18 ms after the change at the earliest
  // and one interval later at the latest; it arrives 20 ms after its beginning.
  EXPECT_NEAR(result.p50_ms, 38 + 0.5 * 1000 / 60, 2.0);
  EXPECT_NEAR(result.p95_ms, 38 + 0.95 * 1000 / 60, 2.0);
  EXPECT_NEAR(result.camera_ms, 20, 0.01);
  EXPECT_NEAR(result.screen_ms, 18 + 0.5 * 1000 / 60, 2.0);
  EXPECT_NEAR(result.frames_per_s, 60, 0.1);
  EXPECT_THAT(result.words(), ::testing::HasSubstr("camera to screen: "));
}

TEST(LatencyMeter, AFieldThatIsNotSeenIsSaid) {
  LatencyMeter meter(40);
  SimulatedRoom(meter, 0).run();
  EXPECT_TRUE(meter.isDone());
  EXPECT_THROW(meter.result(), Error);
}

}  // namespace
}  // namespace facenav::capture
