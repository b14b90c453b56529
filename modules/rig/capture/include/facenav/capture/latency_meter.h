#pragma once
// LatencyMeter: the time from a picture on the screen to that picture of a camera that films the screen, in
// this program. The program shows a field that turns white and black at random moments, the camera films it,
// and the meter searches each change in the pictures as they arrive. The time of one such loop is the
// camera-to-screen latency: light at the camera, arrival here, and the screen's own delay. Thread-safe: the
// field is shown by one thread, pictures arrive on another.

#include <cstdint>
#include <memory>
#include <opencv2/core.hpp>
#include <optional>
#include <string>

namespace facenav::capture {

struct LatencyResult {
  int changes = 0, missed = 0;    // changes that were seen, and that were not
  double p50_ms = 0, p95_ms = 0;  // from the change on the screen to the arrival of its picture
  double screen_ms = 0;           // median, from the change to the time stamp of its picture
  double camera_ms = 0;           // median, from the time stamp to the arrival
  double frames_per_s = 0;
  /// Text of the result: "camera to screen: 46 ms (median), 54 ms (95 %); ..".
  std::string words() const;
};

class LatencyMeter {
 public:
  explicit LatencyMeter(int changes = 60, std::uint64_t seed = 1);
  ~LatencyMeter();

  /// Time of the field's next change and its new colour; steady clock, s. The first change is at once.
  double nextChange_s() const;
  bool isLitNext() const;
  /// Records that the field was changed and handed to the screen at `at_s`.
  void shown(double at_s);
  /// Adds a camera's picture. `grey`: 8-bit, 1 channel. Both times are of the steady clock, s.
  void add(const cv::Mat& grey, double captured_s, double arrived_s);

  /// Progress, 0..1.
  double progress() const;
  bool isDone() const;
  /// The result. Throws Error if the field is not seen in the pictures.
  LatencyResult result() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace facenav::capture
