#pragma once
// SoundPlayer: plays tones through a program of the machine (paplay, else aplay), on its own thread. One
// child process gets a continuous stream, so that a tone costs no start of a program. Where none can play, it
// is silent and says so once.

#include <memory>
#include <string>
#include <vector>

#include "facenav/sounds/tones.h"

namespace facenav::sounds {

/// A program and its arguments; "%" stands for the path to read raw samples from (16 bit, little-endian,
/// mono, kSamplesPerSecond).
using PlayCommand = std::vector<std::string>;
/// paplay, then aplay.
std::vector<PlayCommand> usualPlayers();

class SoundPlayer {
 public:
  /// The first of `players` that works is used. Nothing starts before the first tone.
  explicit SoundPlayer(std::vector<PlayCommand> players = usualPlayers());
  ~SoundPlayer();
  SoundPlayer(const SoundPlayer&) = delete;
  SoundPlayer& operator=(const SoundPlayer&) = delete;

  /// Of the following tones, 0..1.
  void setVolume(double volume);
  void setMuted(bool is_muted);
  /// Returns at once. A tone that still plays is replaced.
  void play(Tone tone);
  /// Why nothing can be heard ("no sound: .."); empty: it can, or was not tried.
  std::string failure() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace facenav::sounds
