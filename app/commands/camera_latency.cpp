#include "commands/camera_latency.h"

#include <unistd.h>

#include <atomic>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <thread>

#include "facenav/capture/latency_meter.h"
#include "facenav/core/error.h"

namespace facenav::app {
namespace {

constexpr int kLatencyChanges = 60;
constexpr double kWithin_s = 60.0;

/// Fills the terminal with one colour, by escape sequences (ECMA-48).
void fillTerminal(bool is_white) {
  std::fputs(is_white ? "\033[48;5;231m\033[2J" : "\033[48;5;16m\033[2J", stderr);
  std::fflush(stderr);
}

/// Flashes the terminal until the meter is done or stop is requested; then restores it.
class Flasher {
 public:
  explicit Flasher(capture::LatencyMeter& meter) : meter_(meter), thread_([this] { run(); }) {}
  ~Flasher() {
    is_stopped_ = true;
    thread_.join();
    std::fputs("\033[0m\033[2J\033[H", stderr);
    std::fflush(stderr);
  }

 private:
  void run() {
    while (!is_stopped_ && !meter_.isDone()) {
      if (Timestamp::now().s >= meter_.nextChange_s()) {
        fillTerminal(meter_.isLitNext());
        meter_.shown(Timestamp::now().s);
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }
  capture::LatencyMeter& meter_;
  std::atomic<bool> is_stopped_{false};
  std::thread thread_;
};

void film(capture::Camera& camera, capture::LatencyMeter& meter) {
  const Flasher flasher(meter);
  for (const double until_s = Timestamp::now().s + kWithin_s;
       Timestamp::now().s < until_s && !meter.isDone();)
    if (const auto picture = camera.next(0.1))
      meter.add(picture->grey, picture->captured.s, Timestamp::now().s);
}

std::string latencyJson(const capture::LatencyResult& result) {
  return nlohmann::ordered_json{{"p50_ms", result.p50_ms},
                                {"p95_ms", result.p95_ms},
                                {"screen_ms", result.screen_ms},
                                {"camera_ms", result.camera_ms},
                                {"changes", result.changes},
                                {"missed", result.missed},
                                {"frames_per_s", result.frames_per_s}}
      .dump(1);
}

}  // namespace

void measureLatency(const capture::CameraBackends& backends, const capture::CameraIdentity& identity,
                    const capture::CameraSettings& settings, bool is_json) {
  if (!::isatty(STDERR_FILENO))
    throw Error("there is no terminal that could flash", "--latency",
                "run it in a terminal and point the camera at it");
  const auto camera = capture::openCamera(backends, identity);
  camera->configure(settings);
  camera->start();
  capture::LatencyMeter meter(kLatencyChanges);
  film(*camera, meter);
  const auto result = meter.result();
  std::printf("%s\n", is_json ? latencyJson(result).c_str() : result.words().c_str());
}

}  // namespace facenav::app
