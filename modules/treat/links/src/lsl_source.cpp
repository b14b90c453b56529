#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "facenav/core/error.h"
#include "lsl_library.h"
#include "sources.h"
#include "threaded_source.h"

namespace facenav::links {
namespace {

constexpr double kLook_s = 0.5, kPull_s = 0.1;
constexpr std::int32_t kBuffer_s = 60;
constexpr const char* kClockNotKnown =
    "the clock of the LSL stream's computer is not known: pulses are timed by their arrival";
constexpr const char* kStampFarAway =
    "the LSL stream's time stamps are more than a second off: pulses are timed by their arrival";

class LslSource : public ThreadedSource {
 public:
  LslSource(const std::string& name, std::string stream, double dead_time_s)
      : ThreadedSource(name, dead_time_s), lsl_(LslLibrary::get()), stream_(std::move(stream)) {}
  ~LslSource() override { stop(); }

 private:
  void open() override {}
  void close() override {}
  void run() override;
  LslLibrary::Inlet find(int& channels);
  void follow(LslLibrary::Inlet inlet, int channels);
  std::optional<double> ahead_s(LslLibrary::Inlet inlet);
  void take(double stamp_s, double arrived_s, std::optional<double> ahead_s);

  const LslLibrary& lsl_;
  std::string stream_;
  bool has_missed_clock_ = false;  // a pulse arrived while the clock was unknown
};

/// Opens the stream's inlet; null: no stream yet, or stopping.
LslLibrary::Inlet LslSource::find(int& channels) {
  LslLibrary::Info info = nullptr;
  const bool is_named = !stream_.empty();
  if (lsl_.resolve_byprop(&info, 1, is_named ? "name" : "type", is_named ? stream_.c_str() : "Markers", 1,
                          kLook_s) < 1)
    return nullptr;
  channels = std::max(1, int(lsl_.get_channel_count(info)));
  const auto inlet = lsl_.create_inlet(info, kBuffer_s, 0, 1);  // 1: waits for a lost stream
  lsl_.destroy_streaminfo(info);
  return inlet;
}

/// Offset to add to the stream's stamps. Nothing: not known yet, or not since the stream's computer came
/// back. Never waits: liblsl estimates it on a thread of its own, first within a second, then every few
/// seconds.
std::optional<double> LslSource::ahead_s(LslLibrary::Inlet inlet) {
  std::int32_t fault = 0;
  const double correction_s = lsl_.time_correction(inlet, 0.0, &fault);
  if (fault != 0) return std::nullopt;
  if (std::exchange(has_missed_clock_, false)) tellProblem("");
  return correction_s;
}

void LslSource::take(double stamp_s, double arrived_s, std::optional<double> ahead_s) {
  if (!ahead_s) {
    has_missed_clock_ = true;
    tellProblem(kClockNotKnown);
    return tellPulse();
  }
  const double age_s = arrived_s - (stamp_s + *ahead_s);
  const bool is_near = std::abs(age_s) < kOldestPulse_s;
  tellProblem(is_near ? "" : kStampFarAway);
  tellPulse(is_near ? std::max(0.0, age_s) : 0.0);
}

void LslSource::follow(LslLibrary::Inlet inlet, int channels) {
  std::vector<char*> texts(std::size_t(channels), nullptr);
  ahead_s(inlet);  // liblsl starts its estimate at the first call
  while (!isStopping()) {
    std::int32_t fault = 0;
    const double stamp_s = lsl_.pull_sample_str(inlet, texts.data(), channels, kPull_s, &fault);
    if (fault != 0 && fault != -1) return;  // -1: no sample in this time
    const double arrived_s = lsl_.local_clock();
    const auto known_s = ahead_s(inlet);
    if (stamp_s == 0) continue;
    for (char*& text : texts)
      if (text) lsl_.destroy_string(std::exchange(text, nullptr));
    take(stamp_s, arrived_s, known_s);
  }
}

void LslSource::run() {
  while (!isStopping()) {
    int channels = 1;
    if (const auto inlet = find(channels)) {
      tellProblem("");
      follow(inlet, channels);
      lsl_.destroy_inlet(inlet);
    } else {
      tellProblem(std::string("no LSL stream") +
                  (stream_.empty() ? " of type Markers" : " named " + stream_) + " is there yet");
    }
  }
}

}  // namespace

std::unique_ptr<PulseSource> makeLslSource(const std::string& name, const std::string& stream,
                                           double dead_time_s) {
  return std::make_unique<LslSource>(name, stream, dead_time_s);
}

}  // namespace facenav::links
