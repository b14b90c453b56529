#include "virtual_display.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>

#include "facenav/core/error.h"

namespace facenav::app {
namespace {

/// Child: Xvfb on a display number of its own choosing, which it writes to `number_pipe`. Does not return.
[[noreturn]] void becomeXvfb(int number_pipe) {
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);  // no orphan, however the parent ends
  ::setpgid(0, 0);                     // Ctrl-C is the parent's to handle
  const int null = ::open("/dev/null", O_RDWR);
  ::dup2(null, STDIN_FILENO);
  ::dup2(null, STDOUT_FILENO);
  ::dup2(null, STDERR_FILENO);
  const std::string descriptor = std::to_string(number_pipe);
  ::execlp("Xvfb", "Xvfb", "-displayfd", descriptor.c_str(), "-screen", "0", "1920x1200x24", "-noreset",
           "-nolisten", "tcp", nullptr);
  ::_exit(127);
}

std::string readDisplayNumber(int pipe) {
  std::string number;
  pollfd waiting{pipe, POLLIN, 0};
  while (::poll(&waiting, 1, 10'000) > 0) {
    char c = 0;
    if (::read(pipe, &c, 1) != 1) return {};
    if (c == '\n') return number;
    number += c;
  }
  return {};
}

}  // namespace

VirtualDisplay::VirtualDisplay() {
  int ends[2];
  if (::pipe(ends) != 0) throw Error("no pipe for the virtual display");
  process_ = ::fork();
  if (process_ == 0) {
    ::close(ends[0]);
    becomeXvfb(ends[1]);
  }
  ::close(ends[1]);
  const std::string number = process_ > 0 ? readDisplayNumber(ends[0]) : std::string();
  ::close(ends[0]);
  if (number.empty()) {
    if (process_ > 0) {
      ::kill(process_, SIGTERM);
      ::waitpid(process_, nullptr, 0);
    }
    throw Error("no display, and no virtual one could be started", "Xvfb", "install the Debian package xvfb");
  }
  ::setenv("DISPLAY", (":" + number).c_str(), 1);
}

VirtualDisplay::~VirtualDisplay() {
  ::unsetenv("DISPLAY");
  ::kill(process_, SIGTERM);
  ::waitpid(process_, nullptr, 0);
}

}  // namespace facenav::app
