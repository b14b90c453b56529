#include "charuco.h"

#include <algorithm>
#include <opencv2/aruco/charuco.hpp>
#include <opencv2/imgproc.hpp>
#include <set>

#include "facenav/cameras/marker_dictionary.h"
#include "facenav/core/error.h"

namespace facenav::cameras {
namespace {

constexpr std::size_t kFewestCorners = 8;

cv::Ptr<cv::aruco::CharucoBoard> printOf(const Board& board) {
  const auto dictionary = cv::aruco::getPredefinedDictionary(predefinedDictionary(board.dictionary));
  const int squares = (board.columns + 1) * (board.rows + 1);
  if (squares / 2 > dictionary->bytesList.rows)
    throw Error("dictionary " + board.dictionary + " has fewer markers than the board's " +
                    std::to_string(squares / 2),
                "--dictionary", "choose a larger one, 5x5_100 say");
  return cv::aruco::CharucoBoard::create(board.columns + 1, board.rows + 1, float(board.square_mm),
                                         float(board.marker_mm.value()), dictionary);
}

/// Refines again with the largest window that does not touch the markers: OpenCV's is smaller.
void refine(const cv::Mat& image, const Board& board, SeenCorners& seen) {
  float spacing_px = 1e9f;
  for (std::size_t i = 0; i < seen.px.size(); ++i)
    for (std::size_t j = i + 1; j < seen.px.size(); ++j)
      spacing_px = std::min(spacing_px, float(cv::norm(seen.px[i] - seen.px[j])));
  const double clear =
      0.5 * (1.0 - board.marker_mm.value() / board.square_mm);  // share of a square, along each side
  const int half = std::clamp(int(0.9 * clear * double(spacing_px)), 2, 25);
  cv::cornerSubPix(image, seen.px, {half, half}, {-1, -1},
                   {cv::TermCriteria::COUNT + cv::TermCriteria::EPS, 100, 1e-4});
}

bool isInOneLine(const std::vector<int>& ids, int columns) {
  std::set<int> rows, seen_columns;
  for (const int id : ids) {
    rows.insert(id / columns);
    seen_columns.insert(id % columns);
  }
  return rows.size() < 2 || seen_columns.size() < 2;
}

}  // namespace

SeenCorners findCharuco(const cv::Mat& image, const Board& board) {
  FACENAV_EXPECT(image.type() == CV_8U, "8-bit grey expected");
  const auto print = printOf(board);
  const auto parameters = cv::aruco::DetectorParameters::create();
  std::vector<std::vector<cv::Point2f>> markers, rejected;
  std::vector<int> marker_ids;
  cv::aruco::detectMarkers(image, print->dictionary, markers, marker_ids, parameters, rejected);
  if (marker_ids.empty()) return {};
  const cv::Ptr<cv::aruco::Board> board_of_markers = print;
  cv::aruco::refineDetectedMarkers(image, board_of_markers, markers, marker_ids, rejected);
  SeenCorners seen;
  cv::aruco::interpolateCornersCharuco(markers, marker_ids, image, print, seen.px, seen.ids);
  if (seen.px.size() < kFewestCorners || isInOneLine(seen.ids, board.columns)) return {};
  refine(image, board, seen);
  return seen;
}

}  // namespace facenav::cameras
