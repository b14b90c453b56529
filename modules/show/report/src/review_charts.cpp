#include "facenav/report/review_charts.h"

#include <algorithm>
#include <cmath>

#include "facenav/core/number_text.h"
#include "facenav/geometry/rotation.h"
#include "facenav/guidance/guidance.h"

namespace facenav::report {
namespace {

using Kind = ChartShape::Kind;
using Anchor = ChartShape::Anchor;

constexpr double kLeft = 44, kRight = 14, kTop = 30, kBottom = 44, kMark = 3;
constexpr int kMostBins = 40, kWantedBins = 16;
constexpr double kNearTarget_mm = 2.0;

ChartShape line(double x, double y, double x2, double y2, Ink ink) { return {Kind::line, ink, x, y, x2, y2}; }
ChartShape words(double x, double y, Anchor anchor, const std::string& text, bool is_bold = false) {
  return {Kind::words, Ink::words, x, y, 0, 0, text, anchor, is_bold};
}

/// Step of 1, 2 or 5 times a power of ten, for about `count` ticks.
double tickStep(double range, int count) {
  const double raw = range / count, power = std::pow(10.0, std::floor(std::log10(raw)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * power >= raw) return factor * power;
  return 10.0 * power;
}

/// Inner rectangle of a plot, with the mapping of its values to the page.
struct Plot {
  double low_x, high_x, low_y, high_y;
  double left, top, width, height;
  Plot(const Chart& chart, double low_x_, double high_x_, double low_y_, double high_y_)
      : low_x(low_x_),
        high_x(high_x_),
        low_y(low_y_),
        high_y(high_y_),
        left(kLeft),
        top(kTop),
        width(chart.width - kLeft - kRight),
        height(chart.height - kTop - kBottom) {}
  double base() const { return top + height; }
  double x(double value) const { return left + width * (value - low_x) / (high_x - low_x); }
  double y(double value) const { return base() - height * (value - low_y) / (high_y - low_y); }
};

void addTitle(Chart& chart, const std::string& title, const std::string& x_label) {
  chart.shapes.push_back(words(chart.width / 2.0, 16, Anchor::middle, title, true));
  chart.shapes.push_back(
      words(kLeft + (chart.width - kLeft - kRight) / 2, chart.height - 10, Anchor::middle, x_label));
}

void addTicksX(Chart& chart, const Plot& plot) {
  const double step = tickStep(plot.high_x - plot.low_x, 6);
  for (double v = std::ceil(plot.low_x / step - 1e-9) * step; v <= plot.high_x + 1e-9; v += step) {
    chart.shapes.push_back(line(plot.x(v), plot.base(), plot.x(v), plot.base() + 4, Ink::axis));
    chart.shapes.push_back(
        words(plot.x(v), plot.base() + 16, Anchor::middle, formatted("%g", std::abs(v) < 1e-9 ? 0.0 : v)));
  }
}

void addTicksY(Chart& chart, const Plot& plot) {
  const double step = tickStep(plot.high_y - plot.low_y, 4);
  for (double v = std::ceil(plot.low_y / step - 1e-9) * step; v <= plot.high_y + 1e-9; v += step) {
    chart.shapes.push_back(line(plot.left, plot.y(v), plot.left + plot.width, plot.y(v), Ink::grid));
    chart.shapes.push_back(
        words(plot.left - 6, plot.y(v) + 4, Anchor::right, formatted("%g", std::abs(v) < 1e-9 ? 0.0 : v)));
  }
}

void addAxes(Chart& chart, const Plot& plot) {
  chart.shapes.push_back(line(plot.left, plot.base(), plot.left + plot.width, plot.base(), Ink::axis));
  chart.shapes.push_back(line(plot.left, plot.top, plot.left, plot.base(), Ink::axis));
}

ChartShape markOf(double x, double y, bool is_on_target, bool is_excluded) {
  if (is_excluded) return {Kind::cross, Ink::excluded, x, y, kMark};
  if (is_on_target) return {Kind::disc, Ink::on_target, x, y, kMark};
  return {Kind::square, Ink::outside, x, y, kMark};
}

std::vector<int> countsOf(const std::vector<double>& values, double low, double bin, std::size_t bins) {
  std::vector<int> counts(bins, 0);
  for (const double value : values)
    ++counts[std::min(bins - 1, std::size_t(std::max(0.0, (value - low) / bin)))];
  return counts;
}

void addBars(Chart& chart, const Plot& plot, const std::vector<int>& counts, double bin) {
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const double from = plot.x(plot.low_x + double(i) * bin), tall = plot.base() - plot.y(counts[i]);
    if (counts[i] > 0)
      chart.shapes.push_back({Kind::box, Ink::bar, from + 0.5, plot.base() - tall,
                              std::max(1.0, plot.width * bin / (plot.high_x - plot.low_x) - 1), tall});
  }
}

Chart histogram(const std::string& title, const std::string& x_label, const std::vector<double>& values,
                double low, double bin, std::size_t bins, std::optional<double> limit, int width,
                int height) {
  Chart chart{width, height, {}};
  const auto counts = countsOf(values, low, bin, bins);
  const int highest = std::max(1, *std::max_element(counts.begin(), counts.end()));
  const Plot plot(chart, low, low + double(bins) * bin, 0, highest);
  addTitle(chart, title, x_label);
  addBars(chart, plot, counts, bin);
  addAxes(chart, plot);
  if (limit && *limit > plot.low_x && *limit < plot.high_x)
    chart.shapes.push_back(line(plot.x(*limit), plot.top, plot.x(*limit), plot.base(), Ink::limit));
  addTicksX(chart, plot);
  chart.shapes.push_back(words(plot.left - 6, plot.top + 8, Anchor::right, std::to_string(highest)));
  chart.shapes.push_back(words(plot.left - 6, plot.base(), Anchor::right, "0"));
  return chart;
}

/// Smallest step of the column's numbers.
double finestOf(PulseColumn column) { return wordsOf(column).decimals > 0 ? 0.1 : 1.0; }

std::string labelOf(PulseColumn column) {
  return std::string(wordsOf(column).name) + " (" + wordsOf(column).unit + ")";
}

}  // namespace

std::optional<double> limitOf(PulseColumn column) {
  if (column == PulseColumn::distance) return kNearTarget_mm;
  if (column == PulseColumn::tilt) return guidance::Tolerance{}.tilt_rad * kDegPerRad;
  return std::nullopt;
}

Chart histogramChart(const std::string& title, const std::string& x_label, const std::vector<double>& values,
                     double bin, double limit, int width, int height) {
  const double largest = values.empty() ? limit : *std::max_element(values.begin(), values.end());
  const double reach = std::max(largest, 1.5 * limit);
  const bool is_cut = reach > kMostBins * bin;
  const auto bins = std::size_t(std::min(double(kMostBins), std::floor(reach / bin) + 1));
  return histogram(title, x_label + (is_cut ? " (last bar: and more)" : ""), values, 0, bin, bins, limit,
                   width, height);
}

Chart histogramOf(const std::vector<casefile::ReviewedPulse>& pulses, PulseColumn column, int width,
                  int height) {
  std::vector<double> values;
  for (const auto& reviewed : pulses)
    if (const auto value = valueOf(reviewed.pulse, column); value && !reviewed.is_excluded)
      values.push_back(*value);
  const std::string title = formatted("Pulses by %s", wordsOf(column).name);
  if (values.empty()) {
    Chart chart{width, height, {}};
    addTitle(chart, title, formatted("no pulse has: %s", wordsOf(column).name));
    return chart;
  }
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const auto limit = limitOf(column);
  const double finest = finestOf(column);
  const double span = limit ? std::max(*high, *limit) : *high - *low;
  const double bin = std::max(finest, tickStep(std::max(span, finest), kWantedBins));
  if (limit && *low >= 0) return histogramChart(title, labelOf(column), values, bin, *limit, width, height);
  const double from = std::floor(*low / bin) * bin;
  const auto bins = std::size_t(std::min(double(kMostBins), std::floor((*high - from) / bin) + 1));
  return histogram(title, labelOf(column), values, from, bin, bins, std::nullopt, width, height);
}

Chart placesChart(const std::string& title, const std::vector<PlacedPulse>& pulses, double limit_mm) {
  Chart chart;
  double most_mm = 2.0 * limit_mm;
  for (const auto& pulse : pulses)
    most_mm = std::max({most_mm, 1.05 * std::abs(pulse.x_mm), 1.05 * std::abs(pulse.y_mm)});
  const double half = (chart.height - kTop - kBottom) / 2, cx = chart.width / 2.0, cy = kTop + half;
  const double scale = half / most_mm;  // units per mm
  chart.shapes.push_back(words(cx, 16, Anchor::middle, title, true));
  chart.shapes.push_back({Kind::frame, Ink::axis, cx - half, cy - half, 2 * half, 2 * half});
  chart.shapes.push_back(line(cx - half, cy, cx + half, cy, Ink::grid));
  chart.shapes.push_back(line(cx, cy - half, cx, cy + half, Ink::grid));
  chart.shapes.push_back({Kind::circle, Ink::limit, cx, cy, scale * limit_mm});
  // The view is along +z, into the head: with y upwards on the page, x = y x z points to the left.
  for (const auto& pulse : pulses)
    chart.shapes.push_back(
        markOf(cx - scale * pulse.x_mm, cy - scale * pulse.y_mm, pulse.is_on_target, pulse.is_excluded));
  const double step = tickStep(most_mm, 3);
  for (double value = -std::floor(most_mm / step) * step; value <= most_mm + 1e-9; value += step)
    chart.shapes.push_back(
        words(cx + scale * value, cy + half + 14, Anchor::middle, formatted("%g", -value + 0.0)));
  chart.shapes.push_back(words(cx, chart.height - 10, Anchor::middle,
                               formatted("mm, seen from above, handle below; dashed: %g mm", limit_mm)));
  return chart;
}

Chart driftChart(const std::vector<casefile::ReviewedPulse>& pulses, PulseColumn column, int width,
                 int height) {
  Chart chart{width, height, {}};
  struct Mark {
    double minutes, value;
    bool is_on_target, is_excluded;
  };
  std::vector<Mark> marks;
  std::optional<double> first_s;
  for (const auto& reviewed : pulses) {
    const casefile::Pulse& pulse = reviewed.pulse;
    const auto value = valueOf(pulse, column);
    // The steady clock, as in the report's trains; t_s is a recording's own clock.
    const auto at_s = pulse.steady_s > 0 ? std::optional(pulse.steady_s) : pulse.t_s;
    if (at_s && (!first_s || *at_s < *first_s)) first_s = at_s;
    if (!at_s || !value) continue;
    marks.push_back({*at_s, *value, pulse.status == casefile::PulseStatus::on_target, reviewed.is_excluded});
  }
  addTitle(
      chart, formatted("%s over time", labelOf(column).c_str()),
      marks.empty() ? formatted("no pulse has: %s", wordsOf(column).name) : "minutes since the first pulse");
  if (marks.empty()) return chart;
  double last = 0, low = limitOf(column) ? 0 : marks.front().value, high = limitOf(column).value_or(low);
  for (Mark& mark : marks) {
    mark.minutes = (mark.minutes - *first_s) / 60.0;
    last = std::max(last, mark.minutes);
    low = std::min(low, mark.value);
    high = std::max(high, mark.value);
  }
  const double room = std::max(0.05 * (high - low), 0.5 * finestOf(column));
  const Plot plot(chart, 0, std::max(last, 1e-3), low == 0 ? 0 : low - room, high + room);
  addTicksY(chart, plot);
  addAxes(chart, plot);
  if (const auto limit = limitOf(column))
    chart.shapes.push_back(
        line(plot.left, plot.y(*limit), plot.left + plot.width, plot.y(*limit), Ink::limit));
  for (const Mark& mark : marks)
    chart.shapes.push_back(
        markOf(plot.x(mark.minutes), plot.y(mark.value), mark.is_on_target, mark.is_excluded));
  addTicksX(chart, plot);
  return chart;
}

}  // namespace facenav::report
