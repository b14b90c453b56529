#pragma once
// A running facenav driven line by line, as another program does it. Compiled with FACENAV_CLI.

#include <gtest/gtest.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace facenav::testing {

class Conversation {
 public:
  enum class Hears { output, output_and_errors };
  explicit Conversation(const std::vector<std::string>& arguments, Hears hears = Hears::output) {
    int in[2], out[2];
    if (::pipe(in) != 0 || ::pipe(out) != 0) throw std::runtime_error("no pipe");
    process_ = ::fork();
    if (process_ == 0) {
      ::dup2(in[0], STDIN_FILENO);
      ::dup2(out[1], STDOUT_FILENO);
      if (hears == Hears::output_and_errors) ::dup2(out[1], STDERR_FILENO);
      for (const int end : {in[0], in[1], out[0], out[1]}) ::close(end);
      std::vector<char*> words{const_cast<char*>(FACENAV_CLI)};
      for (const auto& word : arguments) words.push_back(const_cast<char*>(word.c_str()));
      words.push_back(nullptr);
      ::execv(FACENAV_CLI, words.data());
      ::_exit(127);
    }
    ::close(in[0]);
    ::close(out[1]);
    input_ = in[1];
    output_ = out[0];
  }
  ~Conversation() {
    if (process_ > 0) kill();
    if (process_ > 0) end();
    ::close(output_);
  }
  Conversation(const Conversation&) = delete;
  Conversation& operator=(const Conversation&) = delete;

  void say(const std::string& line) const {
    const std::string text = line + "\n";
    ASSERT_EQ(::write(input_, text.data(), text.size()), ssize_t(text.size()));
  }
  /// Waits for the next line. Returns discarded JSON at the end of the output.
  nlohmann::json hear() {
    return hearWithin(600).value_or(nlohmann::json(nlohmann::json::value_t::discarded));
  }
  /// Returns the next line, if one arrives in this time.
  std::optional<nlohmann::json> hearWithin(double seconds) {
    const auto until = endOf(seconds);
    for (;;) {
      if (const auto newline = heard_.find('\n'); newline != std::string::npos) {
        auto line = nlohmann::json::parse(heard_.substr(0, newline), nullptr, false);
        heard_.erase(0, newline + 1);
        return line;
      }
      if (!listen(until)) return std::nullopt;
    }
  }
  /// Reads until these words arrive, a question for example; earlier output is discarded.
  bool hearWords(const std::string& words, double seconds) {
    const auto until = endOf(seconds);
    for (;;) {
      if (const auto at = heard_.find(words); at != std::string::npos) {
        heard_.erase(0, at + words.size());
        return true;
      }
      if (!listen(until)) return false;
    }
  }
  /// Interrupts the program as Ctrl-C does.
  void interrupt() const { ::kill(process_, SIGINT); }
  void kill() const { ::kill(process_, SIGKILL); }
  /// Closes its input and waits. Returns the exit status; 128 + signal if a signal killed it.
  int end() {
    ::close(input_);
    int status = 0;
    ::waitpid(process_, &status, 0);
    process_ = -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }

 private:
  using Clock = std::chrono::steady_clock;
  static Clock::time_point endOf(double seconds) {
    return Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
  }
  /// Reads more of its output; false if nothing arrived in time, or it has ended.
  bool listen(Clock::time_point until) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(until - Clock::now()).count();
    pollfd waiting{output_, POLLIN, 0};
    if (::poll(&waiting, 1, int(std::max<long>(0, left))) <= 0) return false;
    char buffer[4096];
    const ssize_t size = ::read(output_, buffer, sizeof buffer);
    if (size <= 0) return false;
    heard_.append(buffer, std::size_t(size));
    return true;
  }

  pid_t process_ = -1;
  int input_ = -1, output_ = -1;
  std::string heard_;
};

}  // namespace facenav::testing
