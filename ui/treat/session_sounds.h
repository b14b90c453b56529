#pragma once
// SessionSounds: which tone a change of the guidance makes, and the player with its volume, both remembered.

#include <optional>

#include "facenav/session/navigation_state.h"
#include "facenav/sounds/sound_player.h"

namespace facenav::ui {

/// How near the coil is to the target, as far as a person listens for it.
enum class Nearness { lost, far, near, on_target };
/// near: within kNear_mm of the target.
constexpr double kNear_mm = 10.0;
Nearness nearnessOf(const guidance::GuidanceState& guidance);

/// lost, on_target: when it begins. approaching: on the way in, and when the target was just left. Nothing
/// otherwise.
std::optional<sounds::Tone> toneBetween(Nearness before, Nearness now);

class SessionSounds {
 public:
  SessionSounds();

  /// Each new state of a running session.
  void follow(const guidance::GuidanceState& guidance);
  /// Nothing is heard until the next session.
  void forget() { nearness_.reset(); }
  void pulse() { player_.play(sounds::Tone::pulse); }

  double volume() const { return volume_; }  // 0..1
  bool isMuted() const { return is_muted_; }
  void setVolume(double volume);
  void setMuted(bool is_muted);
  /// Why nothing can be heard; empty: it can.
  std::string failure() const { return player_.failure(); }

 private:
  sounds::SoundPlayer player_;
  std::optional<Nearness> nearness_;
  double volume_ = 0.5;
  bool is_muted_ = false;
};

}  // namespace facenav::ui
