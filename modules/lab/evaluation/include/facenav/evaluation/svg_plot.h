#pragma once
// A plot as SVG text: curves over one axis, with grid, ticks and legend. Used in report.html and as a file.

#include <string>
#include <utility>
#include <vector>

namespace facenav::evaluation {

struct PlotText {
  std::string title, x_label, y_label;
};

struct Curve {
  std::string name;
  std::vector<std::pair<double, double>> points;
  bool is_line = true;        // false: marks only
  bool is_reference = false;  // dashed and grey (the paper's values, a goal)
};

/// Draws the plot in 720 x 400 units. Curves may be empty; non-finite points break the line.
std::string svgPlot(const PlotText& text, const std::vector<Curve>& curves);

}  // namespace facenav::evaluation
