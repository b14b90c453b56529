#include "facenav/core/settings_in_force.h"
#include "facenav/links/pulse_dead_times.h"
#include "facenav/links/pulse_source.h"

namespace facenav::links {

void KeyboardSource::press() {
  if (!listener_.pulse) return;
  PulseTrigger trigger;
  trigger.dead_time_s = settingsOf<PulseDeadTimes>().keyboard_dead_s;
  listener_.pulse(trigger);
}

}  // namespace facenav::links
