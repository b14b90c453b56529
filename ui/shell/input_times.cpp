#include "shell/input_times.h"

#include <QApplication>
#include <QInputEvent>
#include <algorithm>
#include <cmath>

namespace facenav::ui {
namespace {

constexpr double kWrap_s = 4294967.296;  // 2^32 ms
constexpr double kSameClock_s = 10.0;    // a smaller difference at the first event: this machine's clock
constexpr double kReadEarly_s = 0.1;     // the server's clock is coarse, or read a moment later
constexpr double kOldest_s = 60.0;       // an older event means that the server's clock has jumped
constexpr double kDrift = 1e-4;          // of two machines' clocks
constexpr double kHandler_s = 0.2;       // longest time from an event to its handler's question

}  // namespace

Timestamp InputClock::timeOf(unsigned long stamp_ms, Timestamp now) {
  if (stamp_ms == 0) return now;
  const double since_s = std::remainder(now.s - 1e-3 * double(stamp_ms), kWrap_s);
  if (!offset_s_) {
    const bool is_same = since_s > -kReadEarly_s && since_s < kSameClock_s;
    offset_s_ = is_same ? 0.0 : since_s;
  } else if (*offset_s_ != 0.0) {
    offset_s_ = std::min(since_s, *offset_s_ + kDrift * (now - updated_));
  }
  updated_ = now;
  const double age_s = since_s - *offset_s_;
  if (age_s > kOldest_s || age_s < -kReadEarly_s) {
    offset_s_ = since_s;
    return now;
  }
  return {now.s - std::max(0.0, age_s)};
}

InputTimes::InputTimes(QObject* parent) : QObject(parent) { qApp->installEventFilter(this); }

Timestamp InputTimes::pressed() const {
  const Timestamp now = Timestamp::now();
  return now - handled_ < kHandler_s ? pressed_ : now;
}

/// Sees a key twice: as a question whether a field wants it, before shortcuts act, and as the key itself.
bool InputTimes::eventFilter(QObject* watched, QEvent* event) {
  const auto type = event->type();
  if (type == QEvent::ShortcutOverride || type == QEvent::KeyPress || type == QEvent::MouseButtonPress) {
    handled_ = Timestamp::now();
    pressed_ = clock_.timeOf(static_cast<QInputEvent*>(event)->timestamp(), handled_);
  }
  return QObject::eventFilter(watched, event);
}

}  // namespace facenav::ui
