#include "plan/map_legend.h"

#include <QPainter>
#include <algorithm>

#include "shell/appearance.h"

namespace facenav::ui {
namespace {

constexpr int kMapBar_px = 10, kMapRow_px = 34;

}  // namespace

MapLegend::MapLegend(OverlayPresenter& presenter, QWidget* parent) : QWidget(parent), presenter_(presenter) {
  setToolTip(
      tr("colours of the maps: negative on the left, positive on the right; smaller values are not shown"));
  connect(&presenter_, &OverlayPresenter::changed, this, &MapLegend::showMaps);
  whenTextScales(this, [this] { showMaps(); });
}

void MapLegend::showMaps() {
  maps_.clear();
  for (const auto& entry : presenter_.entries())
    if (entry.is_shown && entry.kind == casefile::OverlayKind::map) maps_.push_back(entry);
  setFixedHeight(sized(kMapRow_px) * int(maps_.size()));
  setVisible(!maps_.empty());
  update();
}

void MapLegend::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const int middle = width() / 2, bar = sized(kMapBar_px);
  int top = 0;
  for (const auto& map : maps_) {
    for (int x = 0; x < width(); ++x) {
      const double share = std::abs(x - middle) / double(std::max(1, middle));
      const double size = map.threshold + share * (map.full - map.threshold);
      const auto c = scene::mapColour(x < middle ? -size : size, map.threshold, map.full);
      painter.fillRect(x, top, 1, bar, QColor::fromRgbF(c[0], c[1], c[2]));
    }
    painter.setPen(palette().color(QPalette::WindowText));
    const QRect below(0, top + bar, width(), sized(kMapRow_px) - bar);
    const auto text = [](double value) { return QString::number(value, 'g', 3); };
    painter.drawText(below, Qt::AlignLeft | Qt::AlignTop, "\u2212" + text(map.full));
    painter.drawText(below, Qt::AlignRight | Qt::AlignTop, text(map.full));
    painter.drawText(
        below, Qt::AlignHCenter | Qt::AlignTop,
        tr("%1  \u00b1%2 %3")
            .arg(QString::fromStdString(map.name), text(map.threshold), QString::fromStdString(map.unit)));
    top += sized(kMapRow_px);
  }
}

}  // namespace facenav::ui
