#pragma once
// SoundPlayer: plays tones through the machine's sound output (ALSA), on its own thread. The output gets a
// continuous stream, so that none of a tone is lost while it wakes up. Where there is none, it is silent and
// says so once.

#include <memory>
#include <string>

#include "facenav/sounds/tones.h"

namespace facenav::sounds {

class SoundPlayer {
 public:
  /// `device`: ALSA's name of the output. It is opened at the first tone.
  explicit SoundPlayer(std::string device = "default");
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
