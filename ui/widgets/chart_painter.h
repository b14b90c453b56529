#pragma once
// Draws a workflow::Chart with QPainter: in the window's dark colours, or for white paper.

#include "facenav/workflow/chart.h"

class QPainter;

namespace facenav::ui {

enum class ChartPaper { dark, white };

/// From the painter's origin, one chart unit per painter unit; the background stays as it is.
void paintChart(QPainter& painter, const workflow::Chart& chart, ChartPaper paper);

}  // namespace facenav::ui
