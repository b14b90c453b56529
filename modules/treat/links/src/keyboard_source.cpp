#include <algorithm>

#include "facenav/core/settings_in_force.h"
#include "facenav/links/pulse_dead_times.h"
#include "facenav/links/pulse_source.h"

namespace facenav::links {

void KeyboardSource::press(Timestamp at, const std::string& coil) {
  if (!listener_.pulse) return;
  PulseTrigger trigger;
  const double age_s = std::max(0.0, trigger.at - at);
  trigger.at.s -= age_s;
  trigger.utc -=
      std::chrono::duration_cast<std::chrono::system_clock::duration>(std::chrono::duration<double>(age_s));
  trigger.dead_time_s = settingsOf<PulseDeadTimes>().keyboard_dead_s;
  trigger.coil = coil;
  listener_.pulse(trigger);
}

}  // namespace facenav::links
