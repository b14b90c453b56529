#include <algorithm>
#include <utility>
#include <vector>

#include "facenav/core/error.h"
#include "lsl_library.h"
#include "sources.h"
#include "threaded_source.h"

namespace facenav::links {
namespace {

constexpr double kLook_s = 0.5, kPull_s = 0.1, kCorrection_s = 2.0;
constexpr std::int32_t kBuffer_s = 60;

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

  const LslLibrary& lsl_;
  std::string stream_;
};

/// Null: none is there yet, or stopping.
LslLibrary::Inlet LslSource::find(int& channels) {
  LslLibrary::Info info = nullptr;
  const bool is_named = !stream_.empty();
  if (lsl_.resolve_byprop(&info, 1, is_named ? "name" : "type", is_named ? stream_.c_str() : "Markers", 1,
                          kLook_s) < 1)
    return nullptr;
  channels = std::max(1, int(lsl_.get_channel_count(info)));
  const auto inlet = lsl_.create_inlet(info, kBuffer_s, 0, 1);  // 1: it waits for a stream that was lost
  lsl_.destroy_streaminfo(info);
  return inlet;
}

void LslSource::follow(LslLibrary::Inlet inlet, int channels) {
  std::vector<char*> texts(std::size_t(channels), nullptr);
  std::int32_t fault = 0;
  const double correction_s = lsl_.time_correction(inlet, kCorrection_s, &fault);
  const double ahead_s = fault == 0 ? correction_s : 0;
  while (!isStopping()) {
    fault = 0;
    const double stamp_s = lsl_.pull_sample_str(inlet, texts.data(), channels, kPull_s, &fault);
    if (fault != 0 && fault != -1) return;  // -1: no sample in this time
    if (stamp_s == 0) continue;
    for (char*& text : texts)
      if (text) lsl_.destroy_string(std::exchange(text, nullptr));
    tellPulse(std::max(0.0, lsl_.local_clock() - (stamp_s + ahead_s)));
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
