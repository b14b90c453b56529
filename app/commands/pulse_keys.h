#pragma once
// Pulses by the keyboard of a terminal: Return, space or p; q ends the session. Standard input from a pipe
// works the same way.

#include <termios.h>

#include <optional>

#include "facenav/treat/treatment.h"

namespace facenav::app {

class PulseKeys {
 public:
  /// Switches a terminal to single keys without echo; the destructor restores it.
  explicit PulseKeys(bool is_quiet);
  ~PulseKeys();
  PulseKeys(const PulseKeys&) = delete;
  PulseKeys& operator=(const PulseKeys&) = delete;
  /// Takes the keys that were pressed. Returns false if the session must end.
  bool look(steps::Treatment& treatment);

 private:
  std::optional<termios> before_;  // the terminal's own settings
  bool has_input_ = true;
};

}  // namespace facenav::app
