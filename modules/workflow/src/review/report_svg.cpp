#include "report_svg.h"

#include <algorithm>
#include <cmath>

#include "facenav/core/number_text.h"
#include "report_html.h"

namespace facenav::workflow {
namespace {

constexpr int kWidth = 340, kHeight = 260;
constexpr double kLeft = 44, kRight = 12, kTop = 30, kBottom = 44;
constexpr int kMostBins = 40;
constexpr const char *kBlue = "#0072b2", *kOrange = "#d55e00", *kGrey = "#8a93a0";

std::string opened(const std::string& title) {
  return formatted(
             "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %d %d\" width=\"%d\" height=\"%d\" "
             "font-family=\"sans-serif\" font-size=\"11\">\n",
             kWidth, kHeight, kWidth, kHeight) +
         "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n" +
         formatted("<text x=\"%d\" y=\"16\" text-anchor=\"middle\" font-size=\"13\" font-weight=\"bold\">",
                   kWidth / 2) +
         escapedHtml(title) + "</text>\n";
}

std::string text(double x, double y, const char* anchor, const std::string& words) {
  return formatted("<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"%s\">", x, y, anchor) + escapedHtml(words) +
         "</text>\n";
}

std::string line(double x1, double y1, double x2, double y2, const char* style) {
  return formatted("<line x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\" %s/>\n", x1, y1, x2, y2, style);
}

constexpr const char* kAxis = "stroke=\"#1d2430\"";
constexpr const char* kLimit = "stroke=\"#1d2430\" stroke-dasharray=\"5,4\"";

/// 1, 2 or 5 times a power of ten, for about `count` ticks.
double tickStep(double range, int count) {
  const double raw = range / count, power = std::pow(10.0, std::floor(std::log10(raw)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * power >= raw) return factor * power;
  return 10.0 * power;
}

std::vector<int> countsOf(const std::vector<double>& values, double bin, double most) {
  std::vector<int> counts(std::size_t(std::lround(most / bin)), 0);
  for (const double value : values)
    ++counts[std::min(counts.size() - 1, std::size_t(std::max(0.0, value / bin)))];
  return counts;
}

std::string mark(const PlacedPulse& pulse, double x, double y) {
  const char* colour = pulse.is_excluded ? kGrey : pulse.is_on_target ? kBlue : kOrange;
  if (pulse.is_excluded)
    return formatted("<path d=\"M%.1f %.1fl6 6m0 -6l-6 6\" stroke=\"%s\" fill=\"none\"/>\n", x - 3, y - 3,
                     colour);
  if (pulse.is_on_target)
    return formatted("<circle cx=\"%.1f\" cy=\"%.1f\" r=\"3\" fill=\"%s\" fill-opacity=\"0.6\"/>\n", x, y,
                     colour);
  return formatted("<rect x=\"%.1f\" y=\"%.1f\" width=\"6\" height=\"6\" fill=\"none\" stroke=\"%s\"/>\n",
                   x - 3, y - 3, colour);
}

}  // namespace

std::string histogramSvg(const std::string& title, const std::string& x_label,
                         const std::vector<double>& values, double bin, double limit) {
  const double largest = values.empty() ? limit : *std::max_element(values.begin(), values.end());
  const bool is_cut = std::max(largest, 1.5 * limit) > kMostBins * bin;
  const double most = std::min(double(kMostBins), std::floor(std::max(largest, 1.5 * limit) / bin) + 1) * bin;
  const auto counts = countsOf(values, bin, most);
  const int highest = std::max(1, *std::max_element(counts.begin(), counts.end()));
  const double width = kWidth - kLeft - kRight, height = kHeight - kTop - kBottom, base = kTop + height;
  const auto x = [&](double value) { return kLeft + width * value / most; };
  std::string svg = opened(title);
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const double tall = height * counts[i] / highest;
    if (counts[i] > 0)
      svg += formatted("<rect x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\" fill=\"%s\"/>\n",
                       x(double(i) * bin) + 0.5, base - tall, std::max(1.0, width * bin / most - 1), tall,
                       kBlue);
  }
  svg += line(kLeft, base, kLeft + width, base, kAxis) + line(kLeft, kTop, kLeft, base, kAxis);
  svg += line(x(limit), kTop, x(limit), base, kLimit);
  const double step = tickStep(most, 6);
  for (double value = 0; value <= most + 1e-9; value += step) {
    svg += line(x(value), base, x(value), base + 4, kAxis);
    svg += text(x(value), base + 16, "middle", formatted("%g", value));
  }
  svg += text(kLeft - 6, kTop + 8, "end", std::to_string(highest)) + text(kLeft - 6, base, "end", "0");
  return svg +
         text(kLeft + width / 2, kHeight - 10, "middle", x_label + (is_cut ? " (last bar: and more)" : "")) +
         "</svg>\n";
}

std::string placesSvg(const std::string& title, const std::vector<PlacedPulse>& pulses, double limit_mm) {
  double most_mm = 2.0 * limit_mm;
  for (const auto& pulse : pulses)
    most_mm = std::max({most_mm, 1.05 * std::abs(pulse.x_mm), 1.05 * std::abs(pulse.y_mm)});
  const double half = (kHeight - kTop - kBottom) / 2, cx = kWidth / 2.0, cy = kTop + half;
  const double scale = half / most_mm;  // units per mm
  std::string svg = opened(title);
  svg += formatted("<rect x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\" fill=\"none\" %s/>\n",
                   cx - half, cy - half, 2 * half, 2 * half, kAxis);
  svg += line(cx - half, cy, cx + half, cy, "stroke=\"#ccd3dc\"") +
         line(cx, cy - half, cx, cy + half, "stroke=\"#ccd3dc\"");
  svg += formatted("<circle cx=\"%.1f\" cy=\"%.1f\" r=\"%.1f\" fill=\"none\" %s/>\n", cx, cy,
                   scale * limit_mm, kLimit);
  // Seen along +z, into the head: with y upwards on the page, x = y x z points to the left.
  for (const auto& pulse : pulses) svg += mark(pulse, cx - scale * pulse.x_mm, cy - scale * pulse.y_mm);
  const double step = tickStep(most_mm, 3);
  for (double value = -std::floor(most_mm / step) * step; value <= most_mm + 1e-9; value += step)
    svg += text(cx + scale * value, cy + half + 14, "middle", formatted("%g", -value + 0.0));
  return svg +
         text(cx, kHeight - 10, "middle",
              formatted("mm, seen from above, handle below; dashed: %g mm", limit_mm)) +
         "</svg>\n";
}

}  // namespace facenav::workflow
