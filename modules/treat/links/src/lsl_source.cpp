#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "facenav/core/error.h"
#include "facenav/core/log.h"
#include "facenav/core/number_text.h"
#include "lsl_library.h"
#include "sources.h"
#include "threaded_source.h"

namespace facenav::links {
namespace {

constexpr double kLook_s = 0.5, kPull_s = 0.1;
constexpr std::int32_t kBuffer_s = 60;
constexpr std::uint32_t kMostStreams = 16;  // looked at in one search
constexpr const char* kClockNotKnown =
    "the clock of the LSL stream's computer is not known: pulses are timed by their arrival";
constexpr const char* kStampFarAway =
    "the LSL stream's time stamps are more than a second off: pulses are timed by their arrival";

class LslSource : public ThreadedSource {
 public:
  LslSource(const std::string& name, LslMarkers markers, double dead_time_s)
      : ThreadedSource(name, dead_time_s), lsl_(LslLibrary::get()), markers_(std::move(markers)) {}
  ~LslSource() override { stop(); }

 private:
  void open() override {}
  void close() override {}
  void run() override;
  LslLibrary::Info search(std::int32_t least, bool& has_own) const;
  LslLibrary::Inlet find(int& channels);
  void follow(LslLibrary::Inlet inlet, int channels);
  std::optional<double> ahead_s(LslLibrary::Inlet inlet);
  void take(double stamp_s, double arrived_s, std::optional<double> ahead_s);

  const LslLibrary& lsl_;
  LslMarkers markers_;
  bool has_missed_clock_ = false;  // a pulse arrived while the clock was unknown
};

/// First stream that fits and is not FaceNav's own; null: none. Returns as soon as `least` streams were
/// found.
LslLibrary::Info LslSource::search(std::int32_t least, bool& has_own) const {
  LslLibrary::Info infos[kMostStreams] = {};
  const bool is_named = !markers_.stream.empty();
  const auto count = lsl_.resolve_byprop(infos, kMostStreams, is_named ? "name" : "type",
                                         is_named ? markers_.stream.c_str() : "Markers", least, kLook_s);
  LslLibrary::Info found = nullptr;
  for (std::int32_t i = 0; i < std::min(count, std::int32_t(kMostStreams)); ++i) {
    const char* source = lsl_.get_source_id(infos[i]);
    const bool is_own = source && std::string(source) == kOwnLslSource;
    has_own |= is_own;
    if (!found && !is_own)
      found = infos[i];
    else
      lsl_.destroy_streaminfo(infos[i]);
  }
  return found;
}

/// Opens the stream's inlet; null: no stream yet, or stopping.
LslLibrary::Inlet LslSource::find(int& channels) {
  bool has_own = false;
  LslLibrary::Info info = search(1, has_own);
  if (!info && has_own) info = search(2, has_own);  // its own answer was the first
  if (!info) return nullptr;
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
    bool is_wanted = markers_.marker.empty();
    for (char*& text : texts) {
      is_wanted |= text && markers_.marker == text;
      if (text) lsl_.destroy_string(std::exchange(text, nullptr));
    }
    if (is_wanted) take(stamp_s, arrived_s, known_s);
  }
}

void LslSource::run() {
  while (!isStopping()) {
    int channels = 1;
    if (const auto inlet = find(channels)) {
      tellProblem("");
      logInfo(name() + formatted(": connected; LSL's clock is %.6f s ahead of FaceNav's", lsl_.ahead_s()));
      follow(inlet, channels);
      lsl_.destroy_inlet(inlet);
    } else {
      tellProblem(std::string("no LSL stream") +
                  (markers_.stream.empty() ? " of type Markers" : " named " + markers_.stream) +
                  " is there yet");
    }
  }
}

}  // namespace

std::unique_ptr<PulseSource> makeLslSource(const std::string& name, const LslMarkers& markers,
                                           double dead_time_s) {
  return std::make_unique<LslSource>(name, markers, dead_time_s);
}

}  // namespace facenav::links
