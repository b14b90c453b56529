#include <filesystem>

#include "click_detector.h"
#include "facenav/core/error.h"
#include "facenav/core/settings_in_force.h"
#include "sound_input.h"
#include "sources.h"
#include "threaded_source.h"

namespace facenav::links {
namespace {

constexpr int kListen_ms = 20, kTryAgain_ms = 500;

class SoundSource : public ThreadedSource {
 public:
  SoundSource(const std::string& name, std::string input, double dead_time_s)
      : ThreadedSource(name, dead_time_s), input_name_(std::move(input)), dead_s_(dead_time_s) {}
  ~SoundSource() override { stop(); }

 private:
  void open() override {
    input_ = std::filesystem::is_regular_file(input_name_) ? openSoundFile(input_name_)
                                                           : openSoundDevice(input_name_);
  }
  void close() override { input_.reset(); }
  void run() override;
  SoundInput::Heard listen();

  std::string input_name_;
  double dead_s_;
  std::unique_ptr<SoundInput> input_;
};

/// Listens until the input ends or is gone.
SoundInput::Heard SoundSource::listen() {
  ClickDetector detector(input_->samplesPerSecond(), dead_s_, settingsOf<ClickRules>());
  std::vector<float> samples;
  while (!isStopping()) {
    const auto heard = input_->read(samples, kListen_ms);
    if (heard == SoundInput::Heard::end || heard == SoundInput::Heard::gone) return heard;
    if (heard == SoundInput::Heard::lost_some)
      tellProblem("a part of the sound was lost: clicks in it are not known");
    if (heard != SoundInput::Heard::samples) continue;
    for (const std::int64_t sample : detector.hear(samples.data(), samples.size()))
      tellPulse(Timestamp::now() - input_->timeOf(sample));
    tellProblem("");
  }
  return SoundInput::Heard::end;
}

void SoundSource::run() {
  while (!isStopping()) {
    if (listen() == SoundInput::Heard::end) return tellProblem("the sound is over: no pulse arrives from it");
    tellProblem(input_name_ + " is gone: no click is heard");
    close();
    while (!isStopping() && !input_) {
      waitFor(kTryAgain_ms);
      try {
        open();
        tellProblem("");
      } catch (const Error&) {  // not available yet
        close();
      }
    }
  }
}

}  // namespace

std::unique_ptr<PulseSource> makeSoundSource(const std::string& name, const std::string& input,
                                             double dead_time_s) {
  const auto extension = std::filesystem::path(input).extension();
  const bool is_file = extension == ".wav" || extension == ".flac";
  if (is_file && !std::filesystem::is_regular_file(input))
    throw Error("there is no such sound file", input, "check the path");
  return std::make_unique<SoundSource>(name, input, dead_time_s);
}

}  // namespace facenav::links
