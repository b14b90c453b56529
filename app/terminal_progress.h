#pragma once
// Progress of a long verb as one changing line on stderr, shown on a terminal only.

#include <string>

namespace facenav::app {

class TerminalProgress {
 public:
  /// Shows nothing when `is_quiet` or when stderr is no terminal.
  explicit TerminalProgress(bool is_quiet);
  ~TerminalProgress();
  void show(const std::string& step, double fraction);

 private:
  bool is_shown_;
  std::string last_line_;
};

}  // namespace facenav::app
