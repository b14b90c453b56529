#include "review/chart_view.h"

#include <QPainter>

#include "review/chart_painter.h"
#include "shell/appearance.h"

namespace facenav::ui {
namespace {

double scale() { return sized(100) / 100.0; }

}  // namespace

ChartView::ChartView(QWidget* parent) : QWidget(parent) {
  whenTextScales(this, [this] { setMinimumSize(sized(200), sized(150)); });
}

void ChartView::set(Make make) {
  make_ = std::move(make);
  makeChart();
}

void ChartView::makeChart() {
  chart_ = make_ ? make_(int(width() / scale()), int(height() / scale())) : report::Chart{};
  update();
}

void ChartView::resizeEvent(QResizeEvent*) { makeChart(); }

void ChartView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), palette().color(QPalette::Base));
  painter.scale(scale(), scale());
  paintChart(painter, chart_, ChartPaper::window);
}

}  // namespace facenav::ui
