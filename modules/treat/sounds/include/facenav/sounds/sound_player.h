#pragma once
// SoundPlayer: plays tones through a program of the machine (paplay, else aplay), on its own thread. One
// child process gets a continuous stream, so that a tone starts no program. If no program works, the player
// is silent and reports it once.

#include <memory>
#include <string>
#include <vector>

#include "facenav/sounds/tones.h"

namespace facenav::sounds {

/// Command of a player: a program and its arguments. "%" is replaced by the path of the raw samples (16 bit,
/// little-endian, mono, kSamplesPerSecond).
using PlayCommand = std::vector<std::string>;
/// Default players: paplay, then aplay.
std::vector<PlayCommand> usualPlayers();

class SoundPlayer {
 public:
  /// Builds a player that uses the first of `players` that works. Nothing starts before the first tone.
  explicit SoundPlayer(std::vector<PlayCommand> players = usualPlayers());
  ~SoundPlayer();
  SoundPlayer(const SoundPlayer&) = delete;
  SoundPlayer& operator=(const SoundPlayer&) = delete;

  /// Sets the volume of the following tones, 0..1.
  void setVolume(double volume);
  void setMuted(bool is_muted);
  /// Plays a tone; returns at once. Replaces a tone that still plays.
  void play(Tone tone);
  /// Fault that prevents sound ("no sound: .."); empty: none, or not tried.
  std::string failure() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace facenav::sounds
