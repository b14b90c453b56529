#pragma once
// A small case made of balls, and a way to wait for Qt.

#include <QApplication>
#include <QElapsedTimer>
#include <QThread>
#include <functional>

#include "shell/case_model.h"
#include "support/ball_case.h"
#include "support/test_data.h"

namespace facenav::ui::fixtures {

inline bool waitFor(const std::function<bool()>& condition, int limit_ms = 60000) {
  QElapsedTimer timer;
  timer.start();
  while (!condition() && timer.elapsed() < limit_ms) {
    QApplication::processEvents(QEventLoop::AllEvents, 20);
    QThread::msleep(1);  // leaves the core to the work that is waited for
  }
  return condition();
}

/// Lets a window lay out and paint what has changed. Words that a timer of the page shows must be waited for.
inline void layOut() {
  for (int i = 0; i < 5; ++i) {
    QApplication::sendPostedEvents();
    QApplication::processEvents(QEventLoop::AllEvents, 20);
  }
}

using testing::ballCase;
using testing::ballWithBrain;

inline std::filesystem::path writeBallCase(const std::filesystem::path& folder) {
  casefile::CaseStore::create(folder / "case", ballCase(), {}, false);
  return folder / "case";
}

inline std::shared_ptr<LoadedCase> loadBallCase(const std::filesystem::path& folder) {
  TaskMonitor monitor;
  return loadCase(writeBallCase(folder), monitor);
}

}  // namespace facenav::ui::fixtures
