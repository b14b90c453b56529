#include "facenav/coil_tracking/marker_page.h"

#include <cmath>

#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "facenav/core/whole_file.h"
#include "marker_pattern.h"

namespace facenav::coil_tracking {
namespace {

constexpr double kPageWidth_mm = 210, kPageHeight_mm = 297, kPageMargin_mm = 12;  // A4
constexpr double kRulerHeight_mm = 22, kLabelHeight_mm = 8, kRuler_mm = 100;

std::string number(double value) { return fixed(value, 4); }

std::string rectangle(double x_mm, double y_mm, double width_mm, double height_mm, int grey) {
  const std::string level = std::to_string(grey);
  return "<rect x=\"" + number(x_mm) + "\" y=\"" + number(y_mm) + "\" width=\"" + number(width_mm) +
         "\" height=\"" + number(height_mm) + "\" fill=\"rgb(" + level + "," + level + "," + level +
         ")\"/>\n";
}

std::string label(double x_mm, double y_mm, const std::string& words) {
  return "<text x=\"" + number(x_mm) + "\" y=\"" + number(y_mm) +
         "\" font-size=\"4\" font-family=\"sans-serif\">" + words + "</text>\n";
}

std::string nameOf(const MarkerModel& marker) {
  const std::string what =
      marker.pattern ? std::string("pattern") : marker.dictionary + " id " + std::to_string(marker.id);
  std::string size = number(marker.size_mm);
  size.erase(size.find_last_not_of('0') + 1);
  if (size.back() == '.') size.pop_back();
  return what + ", black square " + size + " mm";
}

/// A black square with its light cells on top. Equal neighbours in a row are joined, so that no hairline
/// shows between them.
std::string square(const MarkerPattern& pattern, double x_mm, double y_mm, double size_mm) {
  std::string svg = rectangle(x_mm, y_mm, size_mm, size_mm, 0);
  const cv::Mat_<float>& cells = pattern.cells();
  const double cell_mm = size_mm / cells.cols;
  for (int row = 0; row < cells.rows; ++row)
    for (int start = 0, end = 0; start < cells.cols; start = end) {
      while (end < cells.cols && cells(row, end) == cells(row, start)) ++end;
      const int grey = int(std::lround(255 * cells(row, start)));
      if (grey > 0)
        svg +=
            rectangle(x_mm + start * cell_mm, y_mm + row * cell_mm, (end - start) * cell_mm, cell_mm, grey);
    }
  return svg;
}

std::string ruler() {
  const double y_mm = kPageMargin_mm + 6;
  return rectangle(kPageMargin_mm, y_mm, kRuler_mm, 0.4, 0) + rectangle(kPageMargin_mm, y_mm - 2, 0.2, 4, 0) +
         rectangle(kPageMargin_mm + kRuler_mm - 0.2, y_mm - 2, 0.2, 4, 0) +
         label(kPageMargin_mm, y_mm - 3,
               "100 mm: print at 100 %, measure this line and the black squares, put the "
               "measured size into coil.json");
}

}  // namespace

std::string markerPageSvg(const CoilModel& coil) {
  std::string svg =
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"210mm\" height=\"297mm\" viewBox=\"0 0 210 "
      "297\">\n" +
      rectangle(0, 0, kPageWidth_mm, kPageHeight_mm, 255) + ruler();
  double y_mm = kPageMargin_mm + kRulerHeight_mm;
  for (const MarkerModel& marker : coil.markers) {
    const MarkerPattern pattern = MarkerPattern::load(marker);
    const double rim_mm = marker.pattern ? marker.size_mm / 8 : marker.size_mm / pattern.cellsPerSide();
    const double needed_mm = marker.size_mm + 2 * rim_mm;
    if (needed_mm > kPageWidth_mm - 2 * kPageMargin_mm || y_mm + needed_mm + kLabelHeight_mm > kPageHeight_mm)
      throw Error("the markers do not fit on an A4 page", nameOf(marker),
                  "make a page for fewer or smaller ones");
    svg += square(pattern, (kPageWidth_mm - marker.size_mm) / 2, y_mm + rim_mm, marker.size_mm);
    svg += label(kPageMargin_mm, y_mm + needed_mm + 3, nameOf(marker));
    y_mm += needed_mm + kLabelHeight_mm;
  }
  return svg + "</svg>\n";
}

void writeMarkerPage(const CoilModel& coil, const std::filesystem::path& path) {
  writeWholeFile(path, markerPageSvg(coil), FileAccess::by_umask);
}

}  // namespace facenav::coil_tracking
