#include "treat/session_sounds.h"

#include <QSettings>

namespace facenav::ui {
namespace {

const char* const kVolume = "sound/volume";
const char* const kMuted = "sound/muted";

}  // namespace

Nearness nearnessOf(const guidance::GuidanceState& guidance) {
  if (guidance.state == guidance::State::lost || !guidance.values) return Nearness::lost;
  if (guidance.state == guidance::State::on_target) return Nearness::on_target;
  return guidance.values->distance_mm <= kNear_mm ? Nearness::near : Nearness::far;
}

std::optional<sounds::Tone> toneBetween(Nearness before, Nearness now) {
  if (now == before || now == Nearness::far) return std::nullopt;
  if (now == Nearness::lost) return sounds::Tone::lost;
  return now == Nearness::on_target ? sounds::Tone::on_target : sounds::Tone::approaching;
}

SessionSounds::SessionSounds() {
  const QSettings settings;
  setVolume(settings.value(kVolume, 0.5).toDouble());
  setMuted(settings.value(kMuted, false).toBool());
}

void SessionSounds::follow(const guidance::GuidanceState& guidance) {
  const Nearness now = nearnessOf(guidance);
  if (nearness_)
    if (const auto tone = toneBetween(*nearness_, now)) player_.play(*tone);
  nearness_ = now;
}

void SessionSounds::setVolume(double volume) {
  volume_ = volume;
  player_.setVolume(volume);
  QSettings().setValue(kVolume, volume);
}

void SessionSounds::setMuted(bool is_muted) {
  is_muted_ = is_muted;
  player_.setMuted(is_muted);
  QSettings().setValue(kMuted, is_muted);
}

}  // namespace facenav::ui
