#pragma once
// Chart: a drawing of lines, bars, marks and words, without colours: each shape has a meaning (Ink), and the
// page or window that draws it chooses the colour. Used for the report (SVG), the window and the PDF. Units:
// 1 = a pixel of the page at usual size; origin top left, y down.

#include <string>
#include <vector>

namespace facenav::report {

enum class Ink { words, axis, grid, limit, on_target, outside, excluded, bar };

struct ChartShape {
  enum class Kind { line, box, frame, disc, circle, square, cross, words };
  Kind kind = Kind::line;
  Ink ink = Ink::axis;
  // line: from x, y to x2, y2. box (filled), frame: corner x, y, size x2, y2. disc, circle (radius x2),
  // square (x2: half its side), cross (likewise): at x, y. words: baseline at x, y.
  double x = 0, y = 0, x2 = 0, y2 = 0;
  std::string text = {};
  enum class Anchor { left, middle, right };
  Anchor anchor = Anchor::left;
  bool is_bold = false;
};

struct Chart {
  int width = 340, height = 260;
  std::vector<ChartShape> shapes;
};

/// Returns the chart as SVG, for a white page.
std::string chartSvg(const Chart& chart);

}  // namespace facenav::report
