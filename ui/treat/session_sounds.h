#pragma once
// SessionSounds: chooses the tone for a change of the guidance; holds the player and its volume, both
// remembered.

#include <optional>

#include "facenav/session/navigation_state.h"
#include "facenav/sounds/sound_player.h"

namespace facenav::ui {

/// How near the coil is to the target, as far as the sounds distinguish it.
enum class Nearness { lost, far, near, on_target };
/// near: within kNear_mm of the target.
constexpr double kNear_mm = 10.0;
Nearness nearnessOf(const guidance::GuidanceState& guidance);

/// Returns the tone for a change. lost, on_target: when that state begins. approaching: on the way in, and
/// when the target was just left. Otherwise nothing.
std::optional<sounds::Tone> toneBetween(Nearness before, Nearness now);

class SessionSounds {
 public:
  SessionSounds();

  /// Follows each new state of a running session.
  void follow(const guidance::GuidanceState& guidance);
  /// Stays silent until the next session.
  void forget() { nearness_.reset(); }
  void pulse() { player_.play(sounds::Tone::pulse); }

  double volume() const { return volume_; }  // 0..1
  bool isMuted() const { return is_muted_; }
  void setVolume(double volume);
  void setMuted(bool is_muted);
  /// Why no sound can be played; empty if it can.
  std::string failure() const { return player_.failure(); }

 private:
  sounds::SoundPlayer player_;
  std::optional<Nearness> nearness_;
  double volume_ = 0.5;
  bool is_muted_ = false;
};

}  // namespace facenav::ui
