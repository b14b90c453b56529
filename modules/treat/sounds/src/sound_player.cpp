#include "facenav/sounds/sound_player.h"

#ifdef FACENAV_HAS_ALSA
#include <alsa/asoundlib.h>
#endif

#include <algorithm>
#include <cerrno>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>

#include "facenav/core/error.h"
#include "facenav/core/log.h"
#include "facenav/core/timestamp.h"

namespace facenav::sounds {
namespace {

constexpr std::size_t kChunk = kSamplesPerSecond / 100;
constexpr std::chrono::milliseconds kChunkTime(10);
constexpr double kAhead_s = 0.05;  // sent before it is heard, against gaps; more would delay tones

#ifdef FACENAV_HAS_ALSA
void beSilent(const char*, int, const char*, int, const char*, ...) {}

/// An open output of the machine. Throws Error if it cannot be opened.
class Output {
 public:
  explicit Output(const std::string& device) {
    constexpr unsigned kBuffer_us = 80000;
    snd_lib_error_set_handler(beSilent);  // its own words would go to the terminal
    const int fault = snd_pcm_open(&pcm_, device.c_str(), SND_PCM_STREAM_PLAYBACK, SND_PCM_NONBLOCK);
    if (fault == -EBUSY) throw Error("the sound output is in use by another program", device);
    if (fault < 0) throw Error("this machine has no sound output", device);
    if (snd_pcm_set_params(pcm_, SND_PCM_FORMAT_S16_LE, SND_PCM_ACCESS_RW_INTERLEAVED, 1, kSamplesPerSecond,
                           1, kBuffer_us) >= 0)
      return;
    snd_pcm_close(pcm_);
    throw Error("the sound output cannot play 16-bit samples", device);
  }
  ~Output() { snd_pcm_close(pcm_); }
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;

  /// How many of the samples it took. Empty: it has gone.
  std::optional<std::size_t> send(const std::int16_t* samples, std::size_t count) const {
    const auto taken = snd_pcm_writei(pcm_, samples, count);
    if (taken >= 0) return std::size_t(taken);
    if (taken != -EAGAIN && snd_pcm_recover(pcm_, int(taken), 1) < 0) return std::nullopt;
    return 0;
  }

 private:
  snd_pcm_t* pcm_ = nullptr;
};
#else
struct Output {
  explicit Output(const std::string& device) { throw Error("FaceNav was built without ALSA", device); }
  std::optional<std::size_t> send(const std::int16_t*, std::size_t) const { return std::nullopt; }
};
#endif

}  // namespace

struct SoundPlayer::Implementation {
  std::string device;
  mutable std::mutex mutex;  // guards the members below
  std::condition_variable changed;
  double volume = 0.5;
  bool is_muted = false, is_stopping = false;
  std::optional<Tone> asked;
  std::string failure;
  std::thread thread;

  void run();
  bool feed(const Output& output);
  std::optional<std::vector<std::int16_t>> takeAsked();
};

/// Returns the samples of a newly requested tone.
std::optional<std::vector<std::int16_t>> SoundPlayer::Implementation::takeAsked() {
  const std::lock_guard lock(mutex);
  if (!asked) return std::nullopt;
  const Tone tone = *asked;
  asked.reset();
  return samplesOf(tone, is_muted ? 0.0 : volume);
}

/// Silence, and tones when asked for, in real time. False: the output has gone.
bool SoundPlayer::Implementation::feed(const Output& output) {
  std::vector<std::int16_t> tone, chunk(kChunk);
  std::size_t next = 0;
  Timestamp started = Timestamp::now();
  for (double sent_s = 0;;) {
    {
      std::unique_lock lock(mutex);
      if (sent_s - (Timestamp::now() - started) > kAhead_s) changed.wait_for(lock, kChunkTime);
      if (is_stopping) return true;
    }
    if (auto samples = takeAsked()) tone = std::move(*samples), next = 0;
    const double late_s = (Timestamp::now() - started) - sent_s;
    if (late_s > 1.0) started.s += late_s;  // the machine slept: skip the missed time
    if (late_s < -kAhead_s) continue;
    for (std::size_t i = 0; i < kChunk; ++i) chunk[i] = next + i < tone.size() ? tone[next + i] : 0;
    const auto sent = output.send(chunk.data(), chunk.size());
    if (!sent) return false;
    if (*sent == 0) std::this_thread::sleep_for(kChunkTime);
    next = std::min(tone.size(), next + *sent);
    sent_s += double(*sent) / kSamplesPerSecond;
  }
}

void SoundPlayer::Implementation::run() {
  {
    std::unique_lock lock(mutex);
    changed.wait(lock, [this] { return is_stopping || asked.has_value(); });
    if (is_stopping) return;
  }
  std::string why = "the sound output has gone";
  try {
    if (feed(Output(device))) return;
  } catch (const std::exception& error) {
    why = error.what();
  }
  const std::lock_guard lock(mutex);
  failure = "no sound: " + why;
  logWarning(failure);
}

SoundPlayer::SoundPlayer(std::string device) : implementation_(std::make_unique<Implementation>()) {
  implementation_->device = std::move(device);
  implementation_->thread = std::thread([i = implementation_.get()] { i->run(); });
}

SoundPlayer::~SoundPlayer() {
  {
    const std::lock_guard lock(implementation_->mutex);
    implementation_->is_stopping = true;
  }
  implementation_->changed.notify_all();
  implementation_->thread.join();
}

void SoundPlayer::setVolume(double volume) {
  const std::lock_guard lock(implementation_->mutex);
  implementation_->volume = volume;
}

void SoundPlayer::setMuted(bool is_muted) {
  const std::lock_guard lock(implementation_->mutex);
  implementation_->is_muted = is_muted;
}

void SoundPlayer::play(Tone tone) {
  {
    const std::lock_guard lock(implementation_->mutex);
    implementation_->asked = tone;
  }
  implementation_->changed.notify_all();
}

std::string SoundPlayer::failure() const {
  const std::lock_guard lock(implementation_->mutex);
  return implementation_->failure;
}

}  // namespace facenav::sounds
