#include "terminal_progress.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace facenav::app {

TerminalProgress::TerminalProgress(bool is_quiet) : is_shown_(!is_quiet && ::isatty(STDERR_FILENO)) {}

TerminalProgress::~TerminalProgress() {
  if (!last_line_.empty()) std::fputs("\r\033[K", stderr);
}

void TerminalProgress::show(const std::string& step, double fraction) {
  if (!is_shown_) return;
  const int percent = int(100.0 * std::clamp(fraction, 0.0, 1.0) + 0.5);
  const std::string line = fraction < 0 ? step : step + " " + std::to_string(percent) + " %";
  if (line == last_line_) return;
  std::fprintf(stderr, "\r\033[K%s", line.c_str());
  std::fflush(stderr);
  last_line_ = line;
}

}  // namespace facenav::app
