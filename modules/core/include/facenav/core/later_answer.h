#pragma once
// LaterAnswer: a question that takes longer than a frame, asked beside the frames. Live, a thread of its own
// works at it at low priority and no frame waits. In recordings the work is done where it is asked, and its
// answer counts from a fixed time later on, so that the same recording always gives the same result. One
// question at a time; the answer is taken once.

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

/// The calling thread, and loops that it starts, give way to all others of the process.
void runInBackground();

template <class Question, class Answer>
class LaterAnswer {
 public:
  using Work = std::function<Answer(const Question&)>;
  enum class Mode { in_line, own_thread };

  /// `answer_s`: in line, from when on after asking the answer counts, by the clock of the questions.
  LaterAnswer(Work work, Mode mode, double answer_s) : work_(std::move(work)), answer_s_(answer_s) {
    FACENAV_EXPECT(bool(work_), "something must work");
    if (mode == Mode::own_thread) worker_ = std::make_unique<Worker>(work_);
  }
  /// Waits for work that runs.
  ~LaterAnswer() = default;
  LaterAnswer(const LaterAnswer&) = delete;
  LaterAnswer& operator=(const LaterAnswer&) = delete;

  bool isBusy() const { return is_busy_; }

  /// Not while isBusy().
  void ask(std::shared_ptr<const Question> question, double now_s) {
    FACENAV_EXPECT(!is_busy_ && question != nullptr, "one question at a time");
    is_busy_ = true, asked_s_ = now_s;
    if (worker_)
      worker_->questions.publish(std::move(question));
    else
      pending_ = answerOf(work_, *question);
  }

  /// The answer, once, when there is one. Empty too where the work failed; that is logged.
  std::optional<Answer> take(double now_s) {
    if (!is_busy_) return std::nullopt;
    if (worker_) {
      const auto answer = worker_->answers.take(std::chrono::milliseconds(0));
      if (!answer) return std::nullopt;
      is_busy_ = false;
      return *answer;
    }
    if (std::abs(now_s - asked_s_) < answer_s_) return std::nullopt;  // a recording may start again
    is_busy_ = false;
    return std::exchange(pending_, std::nullopt);
  }

 private:
  static std::optional<Answer> answerOf(const Work& work, const Question& question) {
    try {
      return work(question);
    } catch (const std::exception& error) {  // no failure beside the frames may end the program
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
    std::thread thread;  // last: starts when the others stand
  };

  Work work_;
  double answer_s_, asked_s_ = 0.0;
  std::unique_ptr<Worker> worker_;  // null: in line
  std::optional<Answer> pending_;
  bool is_busy_ = false;
};

}  // namespace core
}  // namespace facenav
