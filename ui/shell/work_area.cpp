#include "shell/work_area.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QScreen>
#include <QScrollArea>
#include <QStyle>
#include <QTimer>
#include <QWidget>
#include <QWindow>
#include <algorithm>

#include "shell/appearance.h"

namespace facenav::ui {
namespace {

constexpr int kFrameGiven_ms = 250;  // a desktop gives a window its frame some time after it is shown

QRect workAreaOf(const QWidget& window) {
  const QScreen* screen = window.windowHandle() ? window.windowHandle()->screen() : window.screen();
  return screen ? screen->availableGeometry() : QRect(0, 0, 1280, 720);
}

QMargins frameOf(const QWidget& window) {
  const QRect outer = window.frameGeometry(), inner = window.geometry();
  return {inner.left() - outer.left(), inner.top() - outer.top(), outer.right() - inner.right(),
          outer.bottom() - inner.bottom()};
}

/// A row that a scroll area gives its least height: the height that wrapped text would prefer is no reason to
/// scroll.
class LeastHeightRow : public QHBoxLayout {
 public:
  using QHBoxLayout::QHBoxLayout;
  bool hasHeightForWidth() const override { return false; }
};

/// Fits a window again after it was first shown, unless another size was chosen for it meanwhile.
class FitWhenShown : public QObject {
 public:
  explicit FitWhenShown(QWidget& window) : QObject(&window), window_(window), size_(window.size()) {
    window.installEventFilter(this);
  }
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (watched == &window_ && event->type() == QEvent::Show) {
      window_.removeEventFilter(this);
      QTimer::singleShot(kFrameGiven_ms, this, [this] { fit(); });
    }
    return false;
  }

 private:
  void fit() {
    if (window_.size() != size_ || window_.isMaximized() || window_.isFullScreen()) return;
    const QRect area = workAreaOf(window_);
    if (!area.contains(window_.frameGeometry()))
      window_.setGeometry(fittedInto(area, window_.size(), frameOf(window_)));
  }
  QWidget& window_;
  const QSize size_;
};

}  // namespace

QRect fittedInto(const QRect& work_area, const QSize& wanted, const QMargins& frame) {
  const QRect room = work_area.marginsRemoved(frame);
  const QSize size = wanted.boundedTo(room.size());
  return {room.left() + (room.width() - size.width()) / 2, room.top() + (room.height() - size.height()) / 2,
          size.width(), size.height()};
}

void fitIntoWorkArea(QWidget& window, const QSize& usual) {
  const bool has_frame = window.isVisible();
  const int title_px = std::max(0, window.style()->pixelMetric(QStyle::PM_TitleBarHeight));
  window.setGeometry(fittedInto(workAreaOf(window), {sized(usual.width()), sized(usual.height())},
                                has_frame ? frameOf(window) : QMargins(0, title_px, 0, 0)));
  if (!has_frame) new FitWhenShown(window);
}

QScrollArea* scrolledIfSmall(QWidget* content, QWidget* parent) {
  auto* area = new QScrollArea(parent);
  area->setFrameShape(QFrame::NoFrame);
  area->setFocusPolicy(Qt::NoFocus);
  area->setWidgetResizable(true);
  auto* pane = new QWidget(area);
  auto* row = new LeastHeightRow(pane);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(content);
  area->setWidget(pane);
  for (QWidget* each : {pane, area->viewport()}) each->setAutoFillBackground(false);
  return area;
}

}  // namespace facenav::ui
