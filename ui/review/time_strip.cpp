#include "review/time_strip.h"

#include <QMouseEvent>
#include <QPainter>
#include <algorithm>

#include "review/replay_presenter.h"
#include "shell/appearance.h"
#include "shell/theme.h"

namespace facenav::ui {
TimeStrip::TimeStrip(ReplayPresenter& presenter, QWidget* parent) : QWidget(parent), presenter_(presenter) {
  whenTextScales(this, [this] {
    setFixedHeight(sized(44));
    setMinimumWidth(sized(200));
  });
  whenThemeChanges(this, [this] {
    drawBand();
    update();
  });
  setToolTip(
      tr("tall blue: on target; half as tall, orange: to be adjusted; thin grey: lost. Ticks below: pulses, "
         "thick "
         "where on target. Click or drag to go there"));
  connect(&presenter_, &ReplayPresenter::opened, this, [this] {
    drawBand();
    update();
  });
  connect(&presenter_, &ReplayPresenter::moved, this, [this] { update(); });
}

/// Draws the band; each column has the state of most of its frames.
void TimeStrip::drawBand() {
  band_ = QPixmap(size());
  band_.fill(palette().color(QPalette::Base));
  if (!presenter_.isOpen() || width() < 2) return;
  QPainter painter(&band_);
  const auto& track = presenter_.track();
  const auto count = track.moments.size();
  const int room = height() * 2 / 3;
  const QColor good = themeColour(Colour::good), caution = themeColour(Colour::caution),
               none = themeColour(Colour::lost);
  for (int x = 0; x < width(); ++x) {
    const std::size_t from = count * std::size_t(x) / std::size_t(width());
    const std::size_t to =
        std::min(count, std::max(from + 1, count * std::size_t(x + 1) / std::size_t(width())));
    int on_target = 0, adjust = 0, lost = 0;
    for (std::size_t i = from; i < to; ++i) {
      const auto& moment = track.moments[i];
      const bool is_lost = !moment.has_head || !moment.has_coil;
      ++(is_lost ? lost : track.word(moment.state) == "on_target" ? on_target : adjust);
    }
    if (lost >= std::max(on_target, adjust))
      painter.fillRect(x, room - 3, 1, 3, none);
    else if (on_target >= adjust)
      painter.fillRect(x, 0, 1, room, good);
    else
      painter.fillRect(x, room / 2, 1, room - room / 2, caution);
  }
}

void TimeStrip::resizeEvent(QResizeEvent*) { drawBand(); }

void TimeStrip::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  if (band_.isNull() || !presenter_.isOpen())
    return painter.fillRect(rect(), palette().color(QPalette::Base));
  painter.drawPixmap(0, 0, band_);
  const double last = std::max(1, int(presenter_.track().moments.size()) - 1);
  const int below = height() * 2 / 3 + 2;
  for (const auto& pulse : presenter_.pulses()) {
    const int x = int(pulse.index / last * (width() - 1));
    painter.fillRect(x, below, pulse.is_on_target ? 2 : 1, height() - below,
                     themeColour(pulse.is_on_target ? Colour::good : Colour::caution));
  }
  painter.fillRect(int(presenter_.index() / last * (width() - 2)), 0, 2, height(),
                   themeColour(Colour::strong));
}

void TimeStrip::goTo(int x_px) {
  if (!presenter_.isOpen()) return;
  presenter_.pause();
  presenter_.goTo(
      int(double(x_px) / std::max(1, width() - 1) * double(presenter_.track().moments.size() - 1)));
}

void TimeStrip::mousePressEvent(QMouseEvent* event) { goTo(event->x()); }
void TimeStrip::mouseMoveEvent(QMouseEvent* event) {
  if (event->buttons() & Qt::LeftButton) goTo(event->x());
}

}  // namespace facenav::ui
