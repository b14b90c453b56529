#pragma once
// ChildProcess: runs a function or another program in a process of its own. A crash of the child, its memory
// and its signals do not touch this program. The child never outlives the object.

#include <chrono>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace facenav {
inline namespace core {

struct ChildOptions {
  enum class Output { kept, nowhere, file };
  Output output = Output::kept;       // destination of its stdout and stderr
  std::filesystem::path output_file;  // created new, mode 0600
  unsigned time_limit_s = 0;          // wall clock; the child is killed after it; 0: no limit
  bool may_crash = false;             // a crash is expected: no core file, default signal handlers
  bool ends_with_parent = false;      // SIGTERM when the thread that started it ends
  bool ignores_terminal = false;      // own process group: the parent handles Ctrl-C
};

/// End of a child process.
struct ChildEnd {
  int exit_status = -1;  // -1: a signal ended it
  int signal = 0;
  std::string failure;                   // what work() threw
  double processor_s = 0, peak_mib = 0;  // peak resident set, with memory shared at the start
  bool isDone() const { return exit_status == 0; }
};

class ChildProcess {
 public:
  /// Forks and runs `work` in the child. `work` must leave its results in files or shared memory. The exit
  /// status is 0, or 1 if `work` throws. Throws Error if no process can be started.
  static ChildProcess run(const std::function<void()>& work, const ChildOptions& options = {});
  /// Starts another program, given as its name (found by PATH) and its arguments. It inherits open
  /// descriptors without close-on-exec. Throws Error if the program is not installed or cannot be started.
  static ChildProcess start(const std::vector<std::string>& command, const ChildOptions& options = {});

  ChildProcess(ChildProcess&& other) noexcept;
  ChildProcess& operator=(ChildProcess&& other) noexcept;
  /// Kills the child if nobody has waited for it.
  ~ChildProcess();

  /// Waits until the child ends. Call it once.
  ChildEnd wait();
  /// Sends SIGTERM, then SIGKILL after `patience`, and waits for the end.
  ChildEnd end(std::chrono::milliseconds patience = std::chrono::seconds(10));

 private:
  ChildProcess(int process, int words) : process_(process), words_(words) {}
  int process_ = -1, words_ = -1;  // words_: pipe with the message of what work() threw
};

}  // namespace core
}  // namespace facenav
