#include "facenav/capture/latency_meter.h"

#include <algorithm>
#include <mutex>
#include <opencv2/imgproc.hpp>
#include <random>
#include <vector>

#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "facenav/core/robust_statistics.h"

namespace facenav::capture {
namespace {

const cv::Size kLook(80, 60);                       // pictures are reduced to this size
constexpr int kSlowChanges = 6;                     // number of slow changes, in which the field is located
constexpr double kSlow_s = 0.7, kSettled_s = 0.45;  // pictures this long after a change show it whole
constexpr double kShortest_s = 0.25, kLongest_s = 0.5;  // random, so that no rate of the camera fits it
constexpr double kLeastContrast = 8;                    // grey levels between the field's two states

struct Change {
  bool is_lit;
  double at_s;
  std::optional<double> captured_s, arrived_s;  // times of the first picture that shows it
};

}  // namespace

struct LatencyMeter::Implementation {
  Implementation(int fast_changes, std::uint64_t seed) : wanted(fast_changes + kSlowChanges), random(seed) {}

  const int wanted;
  std::mt19937_64 random;
  mutable std::mutex mutex;
  std::vector<Change> changes;
  double next_s = 0;
  cv::Mat lit_sum, dark_sum, mask;
  int lit_count = 0, dark_count = 0;
  double middle_grey = 0;
  std::optional<double> first_s;
  double last_s = 0;
  int frames = 0;

  void learn(const cv::Mat& look, double captured_s);
  void locate();
  void find(const cv::Mat& look, double captured_s, double arrived_s);
  bool isOver() const { return int(changes.size()) > wanted; }
};

/// Adds a picture that shows one state for certain to the sum of that state.
void LatencyMeter::Implementation::learn(const cv::Mat& look, double captured_s) {
  const Change& now = changes.back();
  if (captured_s < now.at_s + kSettled_s || captured_s > next_s) return;
  cv::Mat& sum = now.is_lit ? lit_sum : dark_sum;
  if (sum.empty()) sum = cv::Mat::zeros(look.size(), CV_32F);
  cv::accumulate(look, sum);
  ++(now.is_lit ? lit_count : dark_count);
}

void LatencyMeter::Implementation::locate() {
  if (lit_count == 0 || dark_count == 0) return;
  const cv::Mat difference = lit_sum / lit_count - dark_sum / dark_count;
  double most = 0;
  cv::minMaxLoc(difference, nullptr, &most);
  if (most < kLeastContrast) return;
  mask = difference > 0.6 * most;
  middle_grey = 0.5 * (cv::mean(lit_sum / lit_count, mask)[0] + cv::mean(dark_sum / dark_count, mask)[0]);
}

void LatencyMeter::Implementation::find(const cv::Mat& look, double captured_s, double arrived_s) {
  Change& now = changes.back();
  if (now.arrived_s || mask.empty()) return;
  const bool is_lit = cv::mean(look, mask)[0] > middle_grey;
  if (is_lit != now.is_lit) return;
  now.captured_s = captured_s;
  now.arrived_s = arrived_s;
}

std::string LatencyResult::words() const {
  return formatted(
      "camera to screen: %.0f ms (median), %.0f ms (95 %%), over %d changes, %d missed; %.0f ms of it from "
      "the "
      "screen to the time stamp, %.0f ms from there to this program, at %.0f pictures a second",
      p50_ms, p95_ms, changes, missed, screen_ms, camera_ms, frames_per_s);
}

LatencyMeter::LatencyMeter(int changes, std::uint64_t seed)
    : implementation_(std::make_unique<Implementation>(changes, seed)) {}

LatencyMeter::~LatencyMeter() = default;

double LatencyMeter::nextChange_s() const {
  const std::lock_guard lock(implementation_->mutex);
  return implementation_->next_s;
}

bool LatencyMeter::isLitNext() const {
  const std::lock_guard lock(implementation_->mutex);
  return implementation_->changes.size() % 2 == 0;
}

void LatencyMeter::shown(double at_s) {
  const std::lock_guard lock(implementation_->mutex);
  auto& self = *implementation_;
  self.changes.push_back({self.changes.size() % 2 == 0, at_s, {}, {}});
  if (int(self.changes.size()) == kSlowChanges) self.locate();
  const bool is_slow = int(self.changes.size()) < kSlowChanges;
  self.next_s =
      at_s + (is_slow ? kSlow_s : std::uniform_real_distribution(kShortest_s, kLongest_s)(self.random));
}

void LatencyMeter::add(const cv::Mat& grey, double captured_s, double arrived_s) {
  cv::Mat look;
  cv::resize(grey, look, kLook, 0, 0, cv::INTER_AREA);
  look.convertTo(look, CV_32F);
  const std::lock_guard lock(implementation_->mutex);
  auto& self = *implementation_;
  if (!self.first_s) self.first_s = captured_s;
  self.last_s = captured_s;
  ++self.frames;
  if (self.changes.empty() || self.isOver()) return;
  if (int(self.changes.size()) < kSlowChanges)
    self.learn(look, captured_s);
  else
    self.find(look, captured_s, arrived_s);
}

double LatencyMeter::progress() const {
  const std::lock_guard lock(implementation_->mutex);
  return std::min(1.0, double(implementation_->changes.size()) / double(implementation_->wanted + 1));
}

bool LatencyMeter::isDone() const {
  const std::lock_guard lock(implementation_->mutex);
  const auto& self = *implementation_;
  return self.isOver() || (int(self.changes.size()) >= kSlowChanges && self.mask.empty());
}

LatencyResult LatencyMeter::result() const {
  const std::lock_guard lock(implementation_->mutex);
  const auto& self = *implementation_;
  LatencyResult result;
  std::vector<double> loop_ms, screen_ms, camera_ms;
  // Skips the last change, which had no time to be seen.
  for (std::size_t i = kSlowChanges; i + 1 < self.changes.size(); ++i) {
    const Change& change = self.changes[i];
    if (!change.arrived_s) {
      ++result.missed;
      continue;
    }
    loop_ms.push_back(1e3 * (*change.arrived_s - change.at_s));
    screen_ms.push_back(1e3 * (*change.captured_s - change.at_s));
    camera_ms.push_back(1e3 * (*change.arrived_s - *change.captured_s));
  }
  result.changes = int(loop_ms.size());
  if (self.mask.empty() || result.changes < std::max(5, result.missed))
    throw Error("the camera does not see the flashing field", "",
                "point it at the field, near and sharp, and dim the room");
  std::sort(loop_ms.begin(), loop_ms.end());
  result.p50_ms = median(loop_ms);
  result.p95_ms = loop_ms[std::size_t(0.95 * double(loop_ms.size() - 1) + 0.5)];
  result.screen_ms = median(screen_ms);
  result.camera_ms = median(camera_ms);
  if (self.frames > 1 && self.last_s > *self.first_s)
    result.frames_per_s = (self.frames - 1) / (self.last_s - *self.first_s);
  return result;
}

}  // namespace facenav::capture
