#include "facenav/core/child_process.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <mutex>
#include <thread>
#include <utility>

#include "facenav/core/error.h"

namespace facenav {
inline namespace core {
namespace {

double seconds(const timeval& t) { return double(t.tv_sec) + 1e-6 * double(t.tv_usec); }

void tell(int out, const std::string& words) {
  for (std::size_t done = 0; done < words.size();) {
    const ssize_t written = ::write(out, words.data() + done, words.size() - done);
    if (written < 0 && errno != EINTR) return;
    if (written > 0) done += std::size_t(written);
  }
}

std::string readAll(int in) {
  std::string text;
  char buffer[512];
  for (ssize_t n; (n = ::read(in, buffer, sizeof buffer)) > 0 || (n < 0 && errno == EINTR);)
    if (n > 0) text.append(buffer, std::size_t(n));
  return text;
}

bool sendOutput(const ChildOptions& options) {
  if (options.output == ChildOptions::Output::kept) return true;
  const bool has_file = options.output == ChildOptions::Output::file;
  const int to = has_file ? ::open(options.output_file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600)
                          : ::open("/dev/null", O_WRONLY);
  return to >= 0 && ::dup2(to, STDOUT_FILENO) >= 0 && ::dup2(to, STDERR_FILENO) >= 0;
}

/// Runs in the child. Uses only calls that are safe after a fork of a multi-threaded program.
bool takeUp(const ChildOptions& options) {
  if (options.ends_with_parent) ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (options.ignores_terminal) ::setpgid(0, 0);
  if (options.may_crash) {
    for (const int signal : {SIGALRM, SIGABRT, SIGSEGV, SIGINT, SIGTERM}) ::signal(signal, SIG_DFL);
    const rlimit no_core{0, 0};
    ::setrlimit(RLIMIT_CORE, &no_core);
  }
  if (options.time_limit_s > 0) ::alarm(options.time_limit_s);
  return sendOutput(options);
}

struct Pipe {
  int read = -1, write = -1;
};

Pipe openPipe() {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) throw Error("no pipe can be made", {}, "close other programs");
  return {ends[0], ends[1]};
}

/// Forks. The child runs `begin` with the writing end of the pipe and exits without the parent's destructors.
/// Only one fork at a time: another child would inherit this pipe's writing end, and the reader would wait
/// for that child too.
template <class Begin>
std::pair<int, int> forkWith(Begin&& begin) {
  static std::mutex mutex;
  std::unique_lock<std::mutex> lock(mutex);
  const Pipe pipe = openPipe();
  const int process = ::fork();
  if (process == 0) {
    lock.unlock();  // the child may start children of its own
    ::close(pipe.read);
    ::_exit(begin(pipe.write));
  }
  ::close(pipe.write);
  if (process > 0) return {process, pipe.read};
  ::close(pipe.read);
  throw Error("no process can be started", {}, "close other programs");
}

int runAndTell(const std::function<void()>& work, const ChildOptions& options, int out) {
  if (!takeUp(options)) return 1;
  try {
    work();
  } catch (const std::exception& error) {
    tell(out, error.what());
    return 1;
  } catch (...) {
    tell(out, "failed");
    return 1;
  }
  if (options.output == ChildOptions::Output::kept) std::fflush(nullptr);
  return 0;
}

}  // namespace

ChildProcess ChildProcess::run(const std::function<void()>& work, const ChildOptions& options) {
  // Otherwise parent and child would both write the buffered output.
  if (options.output == ChildOptions::Output::kept) std::fflush(nullptr);
  const auto [process, words] = forkWith([&](int out) { return runAndTell(work, options, out); });
  return {process, words};
}

ChildProcess ChildProcess::start(const std::vector<std::string>& command, const ChildOptions& options) {
  FACENAV_EXPECT(!command.empty(), "a program is needed");
  std::vector<char*> arguments;
  for (const auto& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  const auto [process, words] = forkWith([&](int out) {
    if (takeUp(options)) ::execvp(arguments[0], arguments.data());
    const int fault = errno;
    return ::write(out, &fault, sizeof fault) > 0 ? 127 : 126;
  });
  ChildProcess child(process, words);
  const std::string fault = readAll(words);  // reaches end of file when the program has started
  if (fault.empty()) return child;
  int number = 0;
  std::memcpy(&number, fault.data(), std::min(fault.size(), sizeof number));
  child.wait();
  throw Error(std::string("cannot be started (") + std::strerror(number) + ")", command[0],
              "is it installed?");
}

ChildProcess::ChildProcess(ChildProcess&& other) noexcept
    : process_(std::exchange(other.process_, -1)), words_(std::exchange(other.words_, -1)) {}

ChildProcess& ChildProcess::operator=(ChildProcess&& other) noexcept {
  std::swap(process_, other.process_);
  std::swap(words_, other.words_);
  return *this;
}

ChildProcess::~ChildProcess() {
  if (process_ < 0) return;
  ::kill(process_, SIGKILL);
  wait();
}

ChildEnd ChildProcess::wait() {
  FACENAV_EXPECT(process_ > 0, "a child is waited for once");
  ChildEnd end;
  end.failure = readAll(words_);
  ::close(std::exchange(words_, -1));
  int status = 0;
  rusage usage{};
  const int process = std::exchange(process_, -1);
  while (::wait4(process, &status, 0, &usage) < 0)
    if (errno != EINTR) return end;
  if (WIFEXITED(status)) end.exit_status = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) end.signal = WTERMSIG(status);
  end.processor_s = seconds(usage.ru_utime) + seconds(usage.ru_stime);
  end.peak_mib = double(usage.ru_maxrss) / 1024;
  return end;
}

ChildEnd ChildProcess::end(std::chrono::milliseconds patience) {
  FACENAV_EXPECT(process_ > 0, "the child has been waited for");
  ::kill(process_, SIGTERM);
  const auto until = std::chrono::steady_clock::now() + patience;
  siginfo_t info{};
  while (std::chrono::steady_clock::now() < until) {
    info.si_pid = 0;
    if (::waitid(P_PID, id_t(process_), &info, WEXITED | WNOHANG | WNOWAIT) == 0 && info.si_pid != 0)
      return wait();
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  ::kill(process_, SIGKILL);
  return wait();
}

}  // namespace core
}  // namespace facenav
