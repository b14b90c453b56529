#pragma once
// InputTimes: when a key or mouse button was pressed, whatever later the window came to handle it. The
// display server stamps each event as it reads the device, on its own process; Qt's reader thread passes the
// stamp on. A busy window handles presses late and several at once: their own times keep them apart.

#include <QObject>
#include <optional>

#include "facenav/core/timestamp.h"

namespace facenav::ui {

/// Converts the stamps of input events (ms of the display server's clock, which wraps at 2^32) to the steady
/// clock. A server on this machine uses the same clock. For another one the offset is learnt: it is the
/// smallest difference seen, that of an event handled at once.
class InputClock {
 public:
  /// Time of the event with this stamp, handled at `now`. `now` for a stamp of 0 (made by a program).
  Timestamp timeOf(unsigned long stamp_ms, Timestamp now);

 private:
  std::optional<double> offset_s_;  // steady clock minus the stamps'
  Timestamp updated_;
};

class InputTimes : public QObject {
  Q_OBJECT

 public:
  /// Follows the application's events.
  explicit InputTimes(QObject* parent = nullptr);
  /// Time when the key or button that is handled now was pressed; the present time outside of such a handler.
  Timestamp pressed() const;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  InputClock clock_;
  Timestamp pressed_, handled_;
};

}  // namespace facenav::ui
