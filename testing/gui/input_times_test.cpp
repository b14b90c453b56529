#include "shell/input_times.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QMouseEvent>
#include <QPushButton>
#include <cmath>

namespace facenav::ui {
namespace {

TEST(InputClock, AServerOnThisMachineStampsWithTheSameClock) {
  InputClock clock;
  EXPECT_NEAR(clock.timeOf(5000000, {5000.004}).s, 5000.0, 1e-9);
  EXPECT_NEAR(clock.timeOf(5001000, {5004.0}).s, 5001.0, 1e-9) << "handled three seconds late";
  EXPECT_NEAR(clock.timeOf(5002000, {5004.001}).s, 5002.0, 1e-9) << "and the next one with it";
  EXPECT_DOUBLE_EQ(clock.timeOf(0, {5005.0}).s, 5005.0) << "an event that a program made";
}

TEST(InputClock, WrapsAfterFortyNineDays) {
  InputClock clock;
  const double now_s = 4294967.296 + 100.0;
  EXPECT_NEAR(clock.timeOf(98000, {now_s}).s, now_s - 2.0, 1e-6);
}

TEST(InputClock, AnotherMachinesClockIsLearntFromTheEventHandledSoonest) {
  InputClock clock;
  clock.timeOf(900000, {5000.300});  // handled late: 0.3 s
  clock.timeOf(901000, {5001.002});
  EXPECT_NEAR(clock.timeOf(902000, {5004.0}).s, 5002.002, 0.01) << "handled two seconds late";
}

TEST(InputTimes, AButtonPressHasTheTimeOfItsEvent) {
  InputTimes times;
  QPushButton button;
  Timestamp pressed;
  QObject::connect(&button, &QPushButton::pressed, [&] { pressed = times.pressed(); });
  const Timestamp now = Timestamp::now();
  const auto press = [&](double age_s) {
    QMouseEvent event(QEvent::MouseButtonPress, QPointF(3, 3), Qt::LeftButton, Qt::LeftButton, {});
    event.setTimestamp(ulong(std::fmod(1e3 * (now.s - age_s), 4294967296.0)));
    QApplication::sendEvent(&button, &event);
    button.setDown(false);
    return now.s - pressed.s;
  };
  EXPECT_NEAR(press(0.0), 0.0, 0.02);
  EXPECT_NEAR(press(1.5), 1.5, 0.02);
}

}  // namespace
}  // namespace facenav::ui
