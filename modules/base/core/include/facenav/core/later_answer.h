#pragma once
// LaterAnswer: runs work that takes longer than a frame without delaying the frames. In live use a
// low-priority thread does the work. For recordings the work runs inside ask(), and its answer becomes
// available after a fixed time, so that the same recording always gives the same result. One question at a
// time; each answer is taken once.

#include <chrono>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <utility>

#include "facenav/core/error.h"
#include "facenav/core/latest_value.h"
#include "facenav/core/log.h"

namespace facenav {
inline namespace core {

/// Lowers the priority of the calling thread, and of the loops it starts, below all other threads of the
/// process.
void runInBackground();

/// Time that a live answer takes on one core of a small machine. The microsecond compensates for rounded
/// frame times, which delay every second answer about a recording by a frame.
inline constexpr double kAnswer_s = 0.1 - 1e-6;

template <class Question, class Answer>
class LaterAnswer {
 public:
  using Work = std::function<Answer(const Question&)>;
  enum class Mode { in_line, own_thread };

  /// `answer_s`: when the work runs inside ask(), the time from the question to its answer, by the caller's
  /// clock.
  LaterAnswer(Work work, Mode mode, double answer_s = kAnswer_s)
      : work_(std::move(work)), answer_s_(answer_s) {
    FACENAV_EXPECT(bool(work_), "something must work");
    if (mode == Mode::own_thread) worker_ = std::make_unique<Worker>(work_);
  }
  /// Waits for running work.
  ~LaterAnswer() = default;
  LaterAnswer(const LaterAnswer&) = delete;
  LaterAnswer& operator=(const LaterAnswer&) = delete;

  bool isBusy() const { return is_busy_; }

  /// Must not be called while isBusy().
  void ask(std::shared_ptr<const Question> question, double now_s) {
    FACENAV_EXPECT(!is_busy_ && question != nullptr, "one question at a time");
    is_busy_ = true, asked_s_ = now_s;
    if (worker_)
      worker_->questions.publish(std::move(question));
    else
      pending_ = answerOf(work_, *question);
  }

  /// The answer, once it is available; returned only once. Also empty if the work failed; the failure is
  /// logged.
  std::optional<Answer> take(double now_s) {
    if (!is_busy_) return std::nullopt;
    if (worker_) {
      const auto answer = worker_->answers.take(std::chrono::milliseconds(0));
      if (!answer) return std::nullopt;
      is_busy_ = false;
      return *answer;
    }
    if (std::abs(now_s - asked_s_) < answer_s_) return std::nullopt;  // abs: a recording may start again
    is_busy_ = false;
    return std::exchange(pending_, std::nullopt);
  }

 private:
  static std::optional<Answer> answerOf(const Work& work, const Question& question) {
    try {
      return work(question);
    } catch (const std::exception& error) {  // a failure here must not end the program
      logWarning(std::string("work beside the frames failed: ") + error.what());
      return std::nullopt;
    }
  }

  struct Worker {
    explicit Worker(Work w) : work(std::move(w)), thread([this] { run(); }) {}
    ~Worker() {
      questions.close();
      thread.join();
    }
    void run() {
      runInBackground();
      while (!questions.isClosed()) {
        const auto question = questions.take(std::chrono::milliseconds(200));
        if (!question || questions.isClosed()) continue;
        answers.publish(std::make_shared<std::optional<Answer>>(answerOf(work, *question)));
      }
    }
    Work work;
    LatestValue<Question> questions;
    LatestValue<std::optional<Answer>> answers;
    std::thread thread;  // last: starts after all other members exist
  };

  Work work_;
  double answer_s_, asked_s_ = 0.0;
  std::unique_ptr<Worker> worker_;  // null: work runs inside ask()
  std::optional<Answer> pending_;
  bool is_busy_ = false;
};

}  // namespace core
}  // namespace facenav
