#include "evaluate/measured_child.h"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <exception>

#include "facenav/core/error.h"

namespace facenav::app {
namespace {

double seconds(const timeval& t) { return double(t.tv_sec) + 1e-6 * double(t.tv_usec); }

/// Its failure in one line through the pipe, then out, without the parent's destructors.
[[noreturn]] void runAndLeave(const std::function<void()>& task, int out) {
  std::string failure;
  try {
    task();
  } catch (const std::exception& error) {
    failure = error.what();
  }
  const bool is_told = failure.empty() || ::write(out, failure.data(), failure.size()) >= 0;
  std::fflush(nullptr);
  ::_exit(failure.empty() && is_told ? 0 : 1);
}

std::string readAll(int in) {
  std::string text;
  char buffer[512];
  for (ssize_t n; (n = ::read(in, buffer, sizeof buffer)) > 0;) text.append(buffer, std::size_t(n));
  return text;
}

}  // namespace

ChildMeasure measureInChild(const std::function<void()>& task) {
  int ends[2];
  if (::pipe(ends) != 0) throw Error("no pipe can be made", {}, "close other programs");
  std::fflush(nullptr);
  const auto start = std::chrono::steady_clock::now();
  const pid_t child = ::fork();
  if (child < 0) throw Error("no process can be started", {}, "close other programs");
  if (child == 0) {
    ::close(ends[0]);
    runAndLeave(task, ends[1]);
  }
  ::close(ends[1]);
  ChildMeasure measure;
  measure.failure = readAll(ends[0]);
  ::close(ends[0]);
  int status = 0;
  rusage usage{};
  ::wait4(child, &status, 0, &usage);
  measure.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  measure.processor_s = seconds(usage.ru_utime) + seconds(usage.ru_stime);
  measure.peak_mib = double(usage.ru_maxrss) / 1024;
  if (measure.failure.empty() && !(WIFEXITED(status) && WEXITSTATUS(status) == 0))
    measure.failure = WIFSIGNALED(status) ? "killed by signal " + std::to_string(WTERMSIG(status)) : "failed";
  return measure;
}

}  // namespace facenav::app
