#pragma once
// Pulses by the keyboard of a terminal: Return, space or p; q ends the session. Standard input that is no
// terminal (a pipe) works the same way.

#include <termios.h>

#include <optional>

#include "facenav/treat/treatment.h"

namespace facenav::app {

class PulseKeys {
 public:
  /// A terminal gives its keys at once and unseen until the end.
  explicit PulseKeys(bool is_quiet);
  ~PulseKeys();
  PulseKeys(const PulseKeys&) = delete;
  PulseKeys& operator=(const PulseKeys&) = delete;
  /// Takes the keys that were pressed. False: the session is to end.
  bool look(steps::Treatment& treatment);

 private:
  std::optional<termios> before_;  // the terminal's own settings
  bool has_input_ = true;
};

}  // namespace facenav::app
