#include "facenav/core/later_answer.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace facenav {
namespace {

using Squares = LaterAnswer<int, int>;

int square(const int& n) {
  if (n < 0) throw std::runtime_error("negative");
  return n * n;
}

TEST(LaterAnswer, InLineCountsFromItsTimeOnAndOnce) {
  Squares squares(square, Squares::Mode::in_line, 0.1);
  EXPECT_FALSE(squares.take(0.0));
  squares.ask(std::make_shared<int>(7), 1.0);
  EXPECT_TRUE(squares.isBusy());
  EXPECT_FALSE(squares.take(1.05));
  const auto answer = squares.take(1.1);
  ASSERT_TRUE(answer);
  EXPECT_EQ(*answer, 49);
  EXPECT_FALSE(squares.isBusy());
  EXPECT_FALSE(squares.take(1.2));
}

TEST(LaterAnswer, ComesFromAThreadOfItsOwn) {
  Squares squares(square, Squares::Mode::own_thread, 0.1);
  squares.ask(std::make_shared<int>(9), 1.0);
  std::optional<int> answer;
  for (int i = 0; i < 2000 && !answer; ++i) {
    answer = squares.take(1.0);
    if (!answer) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  EXPECT_EQ(answer, 81);
}

TEST(LaterAnswer, FailedWorkGivesNoAnswerAndTheNextQuestionIsTaken) {
  for (const auto mode : {Squares::Mode::in_line, Squares::Mode::own_thread}) {
    Squares squares(square, mode, 0.0);
    squares.ask(std::make_shared<int>(-1), 1.0);
    for (int i = 0; i < 2000 && squares.isBusy(); ++i) {
      EXPECT_FALSE(squares.take(1.0));
      if (squares.isBusy()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    ASSERT_FALSE(squares.isBusy());
    squares.ask(std::make_shared<int>(3), 1.0);
  }
}

}  // namespace
}  // namespace facenav
