#include "facenav/evaluation/svg_plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>

#include "facenav/core/number_text.h"

namespace facenav::evaluation {
namespace {

constexpr double kWidth = 720, kHeight = 400, kLeft = 70, kRight = 16, kTop = 40, kBottom = 52;
// Okabe-Ito: distinguishable with any colour vision.
constexpr std::array<const char*, 6> kColours{"#0072b2", "#d55e00", "#009e73",
                                              "#cc79a7", "#e69f00", "#56b4e9"};

struct Range {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  void include(double v) {
    low = std::min(low, v);
    high = std::max(high, v);
  }
};

struct Axis {
  double low, high, step;
};

/// Ticks at 1, 2 or 5 times a power of ten, about six of them.
Axis niceAxis(Range range) {
  if (!(range.high >= range.low)) range.low = 0, range.high = 1;
  if (range.high - range.low < 1e-9) range.high = range.low + 1;
  const double raw = (range.high - range.low) / 6;
  const double power = std::pow(10, std::floor(std::log10(raw)));
  double step = 10 * power;
  for (double factor : {1.0, 2.0, 5.0})
    if (factor * power >= raw) {
      step = factor * power;
      break;
    }
  return {std::floor(range.low / step + 1e-9) * step, std::ceil(range.high / step - 1e-9) * step, step};
}

std::string svgEscaped(const std::string& text) {
  std::string out;
  for (char c : text) {
    if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else
      out += c;
  }
  return out;
}

std::string number(double value) { return formatted("%.4g", std::abs(value) < 1e-12 ? 0.0 : value); }

class Canvas {
 public:
  Canvas(const Axis& x, const Axis& y, double top) : x_(x), y_(y), top_(top) {}
  double px(double x) const { return kLeft + (x - x_.low) / (x_.high - x_.low) * (kWidth - kLeft - kRight); }
  double py(double y) const {
    return kHeight - kBottom - (y - y_.low) / (y_.high - y_.low) * (kHeight - top_ - kBottom);
  }

  void drawGrid(std::ostream& svg) const {
    for (double x = x_.low; x <= x_.high + x_.step / 2; x += x_.step)
      svg << "<line x1='" << px(x) << "' x2='" << px(x) << "' y1='" << top_ << "' y2='" << kHeight - kBottom
          << "' stroke='#ddd'/><text x='" << px(x) << "' y='" << kHeight - kBottom + 18
          << "' text-anchor='middle'>" << number(x) << "</text>";
    for (double y = y_.low; y <= y_.high + y_.step / 2; y += y_.step)
      svg << "<line x1='" << kLeft << "' x2='" << kWidth - kRight << "' y1='" << py(y) << "' y2='" << py(y)
          << "' stroke='#ddd'/><text x='" << kLeft - 8 << "' y='" << py(y) + 4 << "' text-anchor='end'>"
          << number(y) << "</text>";
  }
  void drawCurve(std::ostream& svg, const Curve& curve, const std::string& colour) const {
    if (curve.is_line || curve.is_reference) drawLine(svg, curve, colour);
    const bool is_crowded = curve.points.size() > 120;
    if (curve.is_reference || (curve.is_line && is_crowded)) return;
    for (const auto& [x, y] : curve.points)
      if (std::isfinite(x) && std::isfinite(y))
        svg << "<circle cx='" << px(x) << "' cy='" << py(y) << "' r='" << (is_crowded ? 2 : 3) << "' fill='"
            << colour << (is_crowded ? "' fill-opacity='0.5'/>" : "'/>");
  }

 private:
  void drawLine(std::ostream& svg, const Curve& curve, const std::string& colour) const {
    svg << "<path fill='none' stroke='" << colour << "' stroke-width='1.8'"
        << (curve.is_reference ? " stroke-dasharray='6 5'" : "") << " d='";
    bool is_pen_down = false;
    for (const auto& [x, y] : curve.points) {
      const bool is_finite = std::isfinite(x) && std::isfinite(y);
      if (is_finite) svg << (is_pen_down ? 'L' : 'M') << px(x) << ' ' << py(y) << ' ';
      is_pen_down = is_finite;
    }
    svg << "'/>";
  }
  Axis x_, y_;
  double top_;
};

/// Draws as many legend lines as the names need; returns the y below them.
double drawLegend(std::ostream& svg, const std::vector<Curve>& curves,
                  const std::vector<std::string>& colours) {
  constexpr double kRow = 16, kFirst = 32;
  double x = kLeft + 10, y = kFirst;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const double width = 42 + 6.6 * double(curves[i].name.size());
    if (x > kLeft + 10 && x + width > kWidth - kRight) x = kLeft + 10, y += kRow;
    svg << "<line x1='" << x << "' x2='" << x + 22 << "' y1='" << y << "' y2='" << y << "' stroke='"
        << colours[i] << "' stroke-width='3'" << (curves[i].is_reference ? " stroke-dasharray='6 5'" : "")
        << "/><text x='" << x + 27 << "' y='" << y + 4 << "'>" << svgEscaped(curves[i].name) << "</text>";
    x += width;
  }
  return y + kTop - kFirst;
}

}  // namespace

std::string svgPlot(const PlotText& text, const std::vector<Curve>& curves) {
  Range x_range, y_range;
  y_range.include(0);
  std::vector<std::string> colours;
  for (const Curve& curve : curves) {
    colours.push_back(curve.is_reference ? "#777" : kColours[colours.size() % kColours.size()]);
    for (const auto& [x, y] : curve.points)
      if (std::isfinite(x) && std::isfinite(y)) x_range.include(x), y_range.include(y);
  }
  std::ostringstream svg, legend;
  const Canvas canvas(niceAxis(x_range), niceAxis(y_range), drawLegend(legend, curves, colours));
  svg << "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 " << kWidth << ' ' << kHeight
      << "' font-family='sans-serif' font-size='12' fill='#222'><rect width='100%' height='100%' "
         "fill='white'/>";
  svg << "<text x='" << kWidth / 2 << "' y='18' text-anchor='middle' font-size='15'>"
      << svgEscaped(text.title) << "</text>";
  canvas.drawGrid(svg);
  for (std::size_t i = 0; i < curves.size(); ++i) canvas.drawCurve(svg, curves[i], colours[i]);
  svg << legend.str();
  svg << "<text x='" << kWidth / 2 << "' y='" << kHeight - 12 << "' text-anchor='middle'>"
      << svgEscaped(text.x_label) << "</text><text transform='translate(18 " << kHeight / 2
      << ") rotate(-90)' text-anchor='middle'>" << svgEscaped(text.y_label) << "</text></svg>\n";
  return svg.str();
}

}  // namespace facenav::evaluation
