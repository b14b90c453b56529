#include "facenav/core/error.h"
#include "sound_input.h"

#ifdef FACENAV_HAS_ALSA
#include <alsa/asoundlib.h>

#include <cerrno>
#endif

namespace facenav::links {

#ifdef FACENAV_HAS_ALSA
namespace {

void beSilent(const char*, int, const char*, int, const char*, ...) {}

/// Throws Error with advice for the user.
[[noreturn]] void refuseDevice(const std::string& name, int fault) {
  const std::string what =
      fault == -EBUSY    ? "the sound input is in use by another program"
      : fault == -EACCES ? "the sound input may not be used (group audio?)"
      : fault == -ENOENT || fault == -ENODEV || fault == -ENXIO
          ? "there is no such sound input"
          : std::string("the sound input cannot be opened (") + snd_strerror(fault) + ")";
  throw Error(what, name,
              fault == -EBUSY ? "close that program, or use its own input, as sound:default"
                              : "'arecord -L' lists the inputs; is the cable's card plugged in?");
}

class SoundDevice : public SoundInput {
 public:
  explicit SoundDevice(const std::string& name) : clock_(1) {
    snd_lib_error_set_handler(beSilent);  // ALSA would print its messages to the terminal
    int fault = snd_pcm_open(&pcm_, name.c_str(), SND_PCM_STREAM_CAPTURE, SND_PCM_NONBLOCK);
    if (fault < 0) refuseDevice(name, fault);
    fault = prepare();
    if (fault >= 0) return;
    snd_pcm_close(pcm_);
    refuseDevice(name, fault);
  }
  ~SoundDevice() override { snd_pcm_close(pcm_); }
  SoundDevice(const SoundDevice&) = delete;
  SoundDevice& operator=(const SoundDevice&) = delete;
  double samplesPerSecond() const override { return rate_; }
  Timestamp timeOf(std::int64_t sample) const override { return clock_.timeOf(sample); }

  Heard read(std::vector<float>& samples, int wait_ms) override {
    const int ready = snd_pcm_wait(pcm_, wait_ms);
    if (ready == 0) return Heard::nothing_yet;
    if (ready < 0) return recovered(ready);
    std::vector<std::int16_t> all(std::size_t(kMost) * channels_);
    const auto available = snd_pcm_avail(pcm_);
    const Timestamp at = Timestamp::now();
    const auto got = snd_pcm_readi(pcm_, all.data(), kMost);
    if (got == -EAGAIN) return Heard::nothing_yet;
    if (got < 0) return recovered(int(got));
    if (available >= 0) clock_.note(read_ + available, at);
    read_ += got;
    samples.resize(std::size_t(got));
    for (std::size_t i = 0; i < samples.size(); ++i) {
      samples[i] = 0;
      for (unsigned c = 0; c < channels_; ++c)
        samples[i] += float(all[i * channels_ + c]) / (32768.f * float(channels_));
    }
    return Heard::samples;
  }

 private:
  static constexpr snd_pcm_uframes_t kMost = 2048;

  int prepare() {
    snd_pcm_hw_params_t* wanted = nullptr;
    snd_pcm_hw_params_alloca(&wanted);
    int fault = snd_pcm_hw_params_any(pcm_, wanted);
    unsigned buffer_us = 500000, period_us = 5000;
    const auto set = [&](int result) {
      if (fault >= 0) fault = result;
    };
    set(snd_pcm_hw_params_set_access(pcm_, wanted, SND_PCM_ACCESS_RW_INTERLEAVED));
    set(snd_pcm_hw_params_set_format(pcm_, wanted, SND_PCM_FORMAT_S16_LE));
    set(snd_pcm_hw_params_set_rate_near(pcm_, wanted, &rate_, nullptr));
    set(snd_pcm_hw_params_set_channels_near(pcm_, wanted, &channels_));
    snd_pcm_hw_params_set_period_time_near(pcm_, wanted, &period_us,
                                           nullptr);  // a request; the device may use another period
    snd_pcm_hw_params_set_buffer_time_near(pcm_, wanted, &buffer_us, nullptr);
    set(snd_pcm_hw_params(pcm_, wanted));
    if (fault >= 0) set(snd_pcm_start(pcm_));
    clock_ = SampleClock(rate_);
    return fault;
  }

  Heard recovered(int fault) {
    if (fault == -ENODEV || snd_pcm_recover(pcm_, fault, 1) < 0 || snd_pcm_start(pcm_) < 0)
      return Heard::gone;
    clock_.restart();
    return Heard::lost_some;
  }

  snd_pcm_t* pcm_ = nullptr;
  unsigned rate_ = 48000, channels_ = 1;
  SampleClock clock_;
  std::int64_t read_ = 0;
};

}  // namespace

std::unique_ptr<SoundInput> openSoundDevice(const std::string& name) {
  return std::make_unique<SoundDevice>(name);
}
#else
std::unique_ptr<SoundInput> openSoundDevice(const std::string& name) {
  throw Error("FaceNav was built without ALSA: no sound can be heard", name,
              "install libasound2-dev and build again");
}
#endif

}  // namespace facenav::links
