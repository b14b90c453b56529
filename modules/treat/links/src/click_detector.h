#pragma once
// ClickDetector: finds the clicks of a stimulating coil in a stream of sound. A click is a short isolated
// burst above 2 kHz: the 25 ms before it and the time from 4 to 14 ms after it are much quieter. Sounds of a
// voice (beats, "s", "t") are not isolated or last longer. A click is reported 14 ms after its begin.

#include <array>
#include <cstdint>
#include <deque>
#include <vector>

#include "facenav/links/click_rules.h"

namespace facenav::links {

class ClickDetector {
 public:
  /// Builds a detector. `dead_s`: time after a click in which its echoes are ignored.
  ClickDetector(double samples_per_s, double dead_s, const ClickRules& rules = {});
  /// Processes the next samples (-1..1). Returns the sample numbers, counted from the first sample ever, at
  /// which clicks begin.
  std::vector<std::int64_t> hear(const float* samples, std::size_t count);
  double samplesPerSecond() const { return samples_per_s_; }

 private:
  /// Second-order high-pass filter; two in a row are steep enough against voices.
  struct HighPass {
    double b0 = 1, b1 = 0, b2 = 0, a1 = 0, a2 = 0, z1 = 0, z2 = 0;
    double next(double x);
  };
  struct Step {  // an eighth of a millisecond
    double power = 0;
    bool is_click = false;  // part of a detected click or of its echoes
  };
  double most(std::int64_t first, std::int64_t last, bool with_clicks) const;
  std::int64_t stepsOf(double ms) const;
  void endStep();
  bool isClickAt(std::int64_t step) const;
  double usualPeak() const;
  std::int64_t beginOf(std::int64_t step, double peak) const;

  double samples_per_s_;
  ClickRules rules_;
  std::array<HighPass, 2> filters_;
  int samples_per_step_;
  std::int64_t dead_steps_, lookahead_, history_, settled_;
  std::deque<Step> steps_;
  std::int64_t first_step_ = 0;  // number of steps_.front()
  std::int64_t dead_until_ = 0;
  double sum_ = 0, floor_ = -1;
  std::int64_t last_ = -1;  // last click: its step and its power
  double last_peak_ = 0;
  std::deque<double> peaks_;  // peaks of the last clicks
  int in_step_ = 0;
  std::vector<std::int64_t> found_;
};

}  // namespace facenav::links
