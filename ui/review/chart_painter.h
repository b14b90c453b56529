#pragma once
// Draws a report::Chart with QPainter: in the window's dark colours, or for white paper.

#include "facenav/report/chart.h"

class QPainter;

namespace facenav::ui {

enum class ChartPaper { dark, white };

/// From the painter's origin, one chart unit per painter unit; the background stays as it is.
void paintChart(QPainter& painter, const report::Chart& chart, ChartPaper paper);

}  // namespace facenav::ui
