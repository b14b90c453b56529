#include "virtual_display.h"

#include <poll.h>
#include <unistd.h>

#include <cstdlib>

#include "facenav/core/error.h"

namespace facenav::app {
namespace {

/// Starts Xvfb, which chooses a display number and writes it to `number_pipe`.
ChildProcess startXvfb(int number_pipe) {
  ChildOptions options;
  options.output = ChildOptions::Output::nowhere;
  options.ends_with_parent = true;  // ends with the parent in any case
  options.ignores_terminal = true;
  return ChildProcess::start({"Xvfb", "-displayfd", std::to_string(number_pipe), "-screen", "0",
                              "1920x1200x24", "-noreset", "-nolisten", "tcp"},
                             options);
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
  std::string number;
  try {
    xvfb_ = std::make_unique<ChildProcess>(startXvfb(ends[1]));
  } catch (const Error&) {  // reported below
  }
  ::close(ends[1]);
  if (xvfb_) number = readDisplayNumber(ends[0]);
  ::close(ends[0]);
  if (!number.empty()) {
    ::setenv("DISPLAY", (":" + number).c_str(), 1);
    return;
  }
  if (xvfb_) xvfb_->end();
  throw Error("no display, and no virtual one could be started", "Xvfb", "install the Debian package xvfb");
}

VirtualDisplay::~VirtualDisplay() {
  ::unsetenv("DISPLAY");
  xvfb_->end();
}

}  // namespace facenav::app
