#pragma once
// Draws a report::Chart with QPainter: in the window's colours, or for white paper.

#include "facenav/report/chart.h"

class QPainter;

namespace facenav::ui {

enum class ChartPaper { window, white };

/// Paints the chart at the painter's origin, one chart unit per painter unit; the background is not filled.
void paintChart(QPainter& painter, const report::Chart& chart, ChartPaper paper);

}  // namespace facenav::ui
