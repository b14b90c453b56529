#include "commands/pulse_keys.h"

#include <poll.h>
#include <unistd.h>

#include <cstdio>

#include "facenav/core/log.h"

namespace facenav::app {

PulseKeys::PulseKeys(bool is_quiet) {
  termios settings{};
  if (::isatty(STDIN_FILENO) && ::tcgetattr(STDIN_FILENO, &settings) == 0) {
    before_ = settings;
    settings.c_lflag &= ~tcflag_t(ICANON | ECHO);  // Ctrl-C still works
    ::tcsetattr(STDIN_FILENO, TCSANOW, &settings);
  }
  if (!is_quiet) std::fprintf(stderr, "keyboard: Return, space or p for each pulse, q to end\n");
}

PulseKeys::~PulseKeys() {
  if (before_) ::tcsetattr(STDIN_FILENO, TCSANOW, &*before_);
}

bool PulseKeys::look(steps::Treatment& treatment) {
  pollfd input{STDIN_FILENO, POLLIN, 0};
  while (has_input_ && ::poll(&input, 1, 0) > 0) {
    char keys[64];
    const ssize_t size = ::read(STDIN_FILENO, keys, sizeof keys);
    if (size <= 0) {
      has_input_ = false;
      logWarning("standard input has ended: no more pulses from the keyboard, the session goes on");
    }
    for (ssize_t i = 0; i < size; ++i) {
      if (keys[i] == 'q') return false;
      if (keys[i] == '\n' || keys[i] == ' ' || keys[i] == 'p') treatment.pressPulse();
    }
  }
  return true;
}

}  // namespace facenav::app
