#include "facenav/report/chart.h"

#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "report_html.h"

namespace facenav::report {
namespace {

const char* colourOf(Ink ink) {
  switch (ink) {
    case Ink::words:
    case Ink::axis:
    case Ink::limit:
      return "#1d2430";
    case Ink::grid:
      return "#ccd3dc";
    case Ink::on_target:
    case Ink::bar:
      return "#0072b2";
    case Ink::outside:
      return "#d55e00";
    case Ink::excluded:
      return "#8a93a0";
  }
  FACENAV_EXPECT(false, "unknown ink");
}

std::string stroke(Ink ink) {
  return std::string("fill=\"none\" stroke=\"") + colourOf(ink) + "\"" +
         (ink == Ink::limit ? " stroke-dasharray=\"5,4\"" : "");
}

std::string wordsSvg(const ChartShape& s) {
  const char* anchor = s.anchor == ChartShape::Anchor::left     ? "start"
                       : s.anchor == ChartShape::Anchor::middle ? "middle"
                                                                : "end";
  return formatted("<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"%s\"%s>", s.x, s.y, anchor,
                   s.is_bold ? " font-size=\"13\" font-weight=\"bold\"" : "") +
         escapedHtml(s.text) + "</text>\n";
}

std::string shapeSvg(const ChartShape& s) {
  using Kind = ChartShape::Kind;
  const std::string line = stroke(s.ink), fill = std::string("fill=\"") + colourOf(s.ink) + "\"";
  switch (s.kind) {
    case Kind::line:
      return formatted("<line x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\" %s/>\n", s.x, s.y, s.x2, s.y2,
                       line.c_str());
    case Kind::box:
    case Kind::frame:
      return formatted("<rect x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\" %s/>\n", s.x, s.y, s.x2,
                       s.y2, s.kind == Kind::box ? fill.c_str() : line.c_str());
    case Kind::disc:
      return formatted("<circle cx=\"%.1f\" cy=\"%.1f\" r=\"%.1f\" %s fill-opacity=\"0.6\"/>\n", s.x, s.y,
                       s.x2, fill.c_str());
    case Kind::circle:
      return formatted("<circle cx=\"%.1f\" cy=\"%.1f\" r=\"%.1f\" %s/>\n", s.x, s.y, s.x2, line.c_str());
    case Kind::square:
      return formatted("<rect x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\" %s/>\n", s.x - s.x2,
                       s.y - s.x2, 2 * s.x2, 2 * s.x2, line.c_str());
    case Kind::cross:
      return formatted("<path d=\"M%.1f %.1fL%.1f %.1fM%.1f %.1fL%.1f %.1f\" %s/>\n", s.x - s.x2, s.y - s.x2,
                       s.x + s.x2, s.y + s.x2, s.x - s.x2, s.y + s.x2, s.x + s.x2, s.y - s.x2, line.c_str());
    case Kind::words:
      return wordsSvg(s);
  }
  FACENAV_EXPECT(false, "unknown shape");
}

}  // namespace

std::string chartSvg(const Chart& chart) {
  std::string svg = formatted(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %d %d\" width=\"%d\" height=\"%d\" "
      "font-family=\"sans-serif\" font-size=\"11\" fill=\"#1d2430\">\n"
      "<rect width=\"100%%\" height=\"100%%\" fill=\"#ffffff\"/>\n",
      chart.width, chart.height, chart.width, chart.height);
  for (const ChartShape& shape : chart.shapes) svg += shapeSvg(shape);
  return svg + "</svg>\n";
}

}  // namespace facenav::report
