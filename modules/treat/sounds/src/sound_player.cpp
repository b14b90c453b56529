#include "facenav/sounds/sound_player.h"

#include <fcntl.h>
#include <pthread.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <condition_variable>
#include <csignal>
#include <mutex>
#include <optional>
#include <thread>

#include "facenav/core/child_process.h"
#include "facenav/core/error.h"
#include "facenav/core/log.h"
#include "facenav/core/timestamp.h"

namespace facenav::sounds {
namespace {

constexpr std::size_t kChunk = kSamplesPerSecond / 100;
constexpr std::chrono::milliseconds kChunkTime(10);
constexpr double kAhead_s = 0.05;  // sent this early, against gaps; more would delay tones
constexpr int kPipe_bytes = 8192;

/// A player that reads from a pipe. Throws Error if it is not installed.
class Stream {
 public:
  explicit Stream(PlayCommand command) {
    int ends[2];
    if (::pipe2(ends, O_CLOEXEC) != 0) throw Error("no pipe can be made", command[0], "close other programs");
    input_ = ends[1];
    ::fcntl(ends[0], F_SETFD, 0);  // the player inherits the reading end
    ::fcntl(input_, F_SETFL, O_NONBLOCK);
    ::fcntl(input_, F_SETPIPE_SZ, kPipe_bytes);
    for (auto& word : command)
      if (word == "%") word = "/dev/fd/" + std::to_string(ends[0]);
    ChildOptions options;
    options.output = ChildOptions::Output::nowhere;
    options.ends_with_parent = options.ignores_terminal = true;
    try {
      child_.emplace(ChildProcess::start(command, options));
    } catch (const Error&) {
      ::close(ends[0]);
      ::close(input_);
      throw;
    }
    ::close(ends[0]);
  }
  ~Stream() {
    ::close(input_);
    child_->end(std::chrono::milliseconds(500));
  }

  enum class Sent { all, later, broken };
  Sent send(const std::int16_t* samples, std::size_t count) const {
    const ssize_t size = ::write(input_, samples, 2 * count);  // whole or not at all: below PIPE_BUF
    if (size == ssize_t(2 * count)) return Sent::all;
    return size < 0 && (errno == EAGAIN || errno == EINTR) ? Sent::later : Sent::broken;
  }

 private:
  int input_ = -1;
  std::optional<ChildProcess> child_;
};

}  // namespace

std::vector<PlayCommand> usualPlayers() {
  const std::string rate = std::to_string(kSamplesPerSecond);
  return {{"paplay", "--raw", "--rate=" + rate, "--format=s16le", "--channels=1", "--latency-msec=60", "%"},
          {"aplay", "-q", "-t", "raw", "-f", "S16_LE", "-r", rate, "-c", "1", "--buffer-time=80000", "%"}};
}

struct SoundPlayer::Implementation {
  std::vector<PlayCommand> players;
  mutable std::mutex mutex;  // guards the members below
  std::condition_variable changed;
  double volume = 0.5;
  bool is_muted = false, is_stopping = false;
  std::optional<Tone> asked;
  Tone playing = Tone::lost;
  std::string failure;
  std::thread thread;

  void run();
  bool feed(const Stream& stream);
  std::optional<std::vector<std::int16_t>> takeAsked();
  void askAgain();
};

/// Returns the samples of a newly requested tone.
std::optional<std::vector<std::int16_t>> SoundPlayer::Implementation::takeAsked() {
  const std::lock_guard lock(mutex);
  if (!asked) return std::nullopt;
  playing = *asked;
  asked.reset();
  return samplesOf(playing, is_muted ? 0.0 : volume);
}

/// Requests the tone again, because the player ended before it was over.
void SoundPlayer::Implementation::askAgain() {
  const std::lock_guard lock(mutex);
  if (!asked) asked = playing;
}

/// Sends silence, and tones on request, in real time. Returns false if the player has ended.
bool SoundPlayer::Implementation::feed(const Stream& stream) {
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
    const auto sent = stream.send(chunk.data(), chunk.size());
    if (sent == Stream::Sent::broken) {
      if (next < tone.size()) askAgain();
      return false;
    }
    if (sent == Stream::Sent::later) {
      std::this_thread::sleep_for(kChunkTime);
      continue;
    }
    next = std::min(tone.size(), next + kChunk);
    sent_s += double(kChunk) / kSamplesPerSecond;
  }
}

void SoundPlayer::Implementation::run() {
  sigset_t broken_pipe;  // a player that ended is noticed by write(), not by a signal that ends this program
  sigemptyset(&broken_pipe);
  sigaddset(&broken_pipe, SIGPIPE);
  ::pthread_sigmask(SIG_BLOCK, &broken_pipe, nullptr);
  {
    std::unique_lock lock(mutex);
    changed.wait(lock, [this] { return is_stopping || asked.has_value(); });
    if (is_stopping) return;
  }
  for (const PlayCommand& player : players) {
    try {
      if (feed(Stream(player))) return;
    } catch (const std::exception&) {  // not installed: the next one
    }
  }
  const std::lock_guard lock(mutex);
  failure = "no sound: no player works on this machine (paplay, aplay)";
  logWarning(failure);
}

SoundPlayer::SoundPlayer(std::vector<PlayCommand> players)
    : implementation_(std::make_unique<Implementation>()) {
  implementation_->players = std::move(players);
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
