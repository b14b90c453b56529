#include "shell/task_runner.h"

#include <gtest/gtest.h>

#include "facenav/core/error.h"
#include "gui_fixtures.h"

namespace facenav::ui {
namespace {

TEST(TaskRunner, WorksElsewhereAndDeliversOnTheGuiThread) {
  TaskRunner tasks;
  std::thread::id worker, delivered;
  bool has_succeeded = false;
  QObject::connect(&tasks, &TaskRunner::succeeded, [&] { has_succeeded = true; });
  tasks.start("task", [&](TaskMonitor& monitor) -> TaskRunner::Delivery {
    monitor.report("half", 0.5);
    worker = std::this_thread::get_id();
    return [&] { delivered = std::this_thread::get_id(); };
  });
  EXPECT_FALSE(tasks.start("second", [](TaskMonitor&) { return TaskRunner::Delivery(); }));  // one at a time
  ASSERT_TRUE(fixtures::waitFor([&] { return has_succeeded; }));
  EXPECT_NE(worker, std::this_thread::get_id());
  EXPECT_EQ(delivered, std::this_thread::get_id());
}

TEST(TaskRunner, AnErrorArrivesInWordsAndNothingIsDelivered) {
  TaskRunner tasks;
  QString words;
  QObject::connect(&tasks, &TaskRunner::failed, [&](const QString& w) { words = w; });
  tasks.start("task", [](TaskMonitor&) -> TaskRunner::Delivery { throw Error("no head in this volume"); });
  ASSERT_TRUE(fixtures::waitFor([&] { return !words.isEmpty(); }));
  EXPECT_TRUE(words.contains("no head in this volume"));
}

TEST(TaskRunner, CancelEndsTheTaskAtItsNextReport) {
  TaskRunner tasks;
  bool was_cancelled = false;
  QObject::connect(&tasks, &TaskRunner::cancelled, [&] { was_cancelled = true; });
  tasks.start("task", [](TaskMonitor& monitor) -> TaskRunner::Delivery {
    for (;;) {
      monitor.report("for ever", 0.1);
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
  });
  tasks.cancel();
  EXPECT_TRUE(fixtures::waitFor([&] { return was_cancelled; }));
}

}  // namespace
}  // namespace facenav::ui
