#pragma once
// ChildProcess: work in a process of its own, or another program. Its crash, memory and signals are its own;
// it never outlives the object.

#include <chrono>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace facenav {
inline namespace core {

struct ChildOptions {
  enum class Output { kept, nowhere, file };
  Output output = Output::kept;       // of its stdout and stderr
  std::filesystem::path output_file;  // made anew, mode 0600
  unsigned time_limit_s = 0;          // of wall clock, then it is killed; 0: none
  bool may_crash = false;             // expected to: no core file, and signals end it as they do by default
  bool ends_with_parent = false;      // SIGTERM when the thread that started it ends
  bool ignores_terminal = false;      // a process group of its own: Ctrl-C is the parent's to handle
};

/// How a child ended.
struct ChildEnd {
  int exit_status = -1;  // -1: a signal ended it
  int signal = 0;
  std::string failure;                   // what work() threw
  double processor_s = 0, peak_mib = 0;  // peak: resident set, with what the parent held at the start
  bool isDone() const { return exit_status == 0; }
};

class ChildProcess {
 public:
  /// Forks and runs `work` there; what it makes it must leave in files or shared memory. Exit status 0, or 1
  /// where it throws. Throws Error where no process can be started.
  static ChildProcess run(const std::function<void()>& work, const ChildOptions& options = {});
  /// Another program: its name (found by PATH) and arguments; open descriptors without close-on-exec go with
  /// it. Throws Error where it is not installed or cannot be started.
  static ChildProcess start(const std::vector<std::string>& command, const ChildOptions& options = {});

  ChildProcess(ChildProcess&& other) noexcept;
  ChildProcess& operator=(ChildProcess&& other) noexcept;
  /// Kills the child where nobody has waited for it.
  ~ChildProcess();

  /// Waits for its end, once.
  ChildEnd wait();
  /// SIGTERM, after `patience` SIGKILL; waits.
  ChildEnd end(std::chrono::milliseconds patience = std::chrono::seconds(10));

 private:
  ChildProcess(int process, int words) : process_(process), words_(words) {}
  int process_ = -1, words_ = -1;  // words_: reads what work() threw
};

}  // namespace core
}  // namespace facenav
