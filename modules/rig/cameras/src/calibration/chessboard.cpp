#include "facenav/cameras/chessboard.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include "charuco.h"
#include "facenav/core/error.h"
#include "facenav/core/number_text.h"

namespace facenav::cameras {
namespace {

using Corners = std::vector<cv::Point2f>;

constexpr double kLeastSquare_mm = 0.5, kMostSquare_mm = 1000;  // beyond: given in metres or micrometres

// Half window of the sub-pixel refinement, as a fraction of the least distance of two corners. At 0.4 the
// window extends past the last squares. Evidence: resources/doc/evidence.md.
constexpr float kWindowBySpacing = 0.3f;

// Larger images are searched at half their size first, which is several times as fast.
constexpr int kLarge_px = 900;

// Longer side of the reduced copy in which a live picture is searched. Smaller copies miss small boards.
constexpr int kLive_px = 720;

constexpr int kThorough = cv::CALIB_CB_ADAPTIVE_THRESH | cv::CALIB_CB_NORMALIZE_IMAGE;

Corners detect(const cv::Mat& image, const Board& board, int how = kThorough) {
  Corners corners;
  const bool is_found = cv::findChessboardCorners(image, {board.columns, board.rows}, corners, how);
  return is_found && int(corners.size()) == board.corners() ? corners : Corners();
}

// Finds the corners with an error of a pixel or two.
Corners detectQuickly(const cv::Mat& image, const Board& board) {
  if (std::max(image.cols, image.rows) > kLarge_px) {
    cv::Mat half;
    cv::resize(image, half, {}, 0.5, 0.5, cv::INTER_AREA);
    Corners corners = detect(half, board);
    for (auto& corner : corners) corner = 2 * corner + cv::Point2f(0.5f, 0.5f);
    if (!corners.empty()) return corners;
  }
  return detect(image, board);
}

float leastSpacing_px(const Corners& corners, const Board& board) {
  float least = 1e9f;
  for (int r = 0; r < board.rows; ++r)
    for (int c = 0; c < board.columns; ++c) {
      const cv::Point2f here = corners[r * board.columns + c];
      if (c + 1 < board.columns)
        least = std::min(least, float(cv::norm(corners[r * board.columns + c + 1] - here)));
      if (r + 1 < board.rows)
        least = std::min(least, float(cv::norm(corners[(r + 1) * board.columns + c] - here)));
    }
  return least;
}

void refine(const cv::Mat& image, const Board& board, Corners& corners) {
  const int half = std::clamp(int(std::lround(kWindowBySpacing * leastSpacing_px(corners, board))), 2, 25);
  cv::cornerSubPix(image, corners, {half, half}, {-1, -1},
                   {cv::TermCriteria::COUNT + cv::TermCriteria::EPS, 100, 1e-4});
}

double meanGrey(const cv::Mat& image, const Corners& corners, const Board& board, int row, int column) {
  const int i = row * board.columns + column;
  const cv::Point2f middle =
      0.25f * (corners[i] + corners[i + 1] + corners[i + board.columns] + corners[i + board.columns + 1]);
  const int half = std::max(1, int(leastSpacing_px(corners, board) / 6));
  const cv::Rect square(int(std::lround(middle.x)) - half, int(std::lround(middle.y)) - half, 2 * half + 1,
                        2 * half + 1);
  return cv::mean(image(square & cv::Rect(0, 0, image.cols, image.rows)))[0];
}

// Compares the mean grey of all squares of both colours.
bool isFirstSquareBlack(const cv::Mat& image, const Corners& corners, const Board& board) {
  double difference = 0;
  for (int r = 0; r + 1 < board.rows; ++r)
    for (int c = 0; c + 1 < board.columns; ++c)
      difference += ((r + c) % 2 == 0 ? 1 : -1) * meanGrey(image, corners, board, r, c);
  return difference < 0;
}

// Rows left to right as seen from the front (the detector may start at either end of a row).
void makeRightHanded(const Board& board, Corners& corners) {
  const cv::Point2f along = corners[board.columns - 1] - corners[0];
  const cv::Point2f down = corners[std::size_t(board.columns) * (board.rows - 1)] - corners[0];
  if (along.cross(down) > 0) return;
  for (int r = 0; r < board.rows; ++r)
    std::reverse(corners.begin() + std::ptrdiff_t(r) * board.columns,
                 corners.begin() + std::ptrdiff_t(r + 1) * board.columns);
}

}  // namespace

Board boardFromText(const std::string& whole, double square_mm, std::optional<double> marker_mm) {
  const std::string prefix = "charuco:";
  const bool is_charuco = whole.rfind(prefix, 0) == 0;
  const std::string text = is_charuco ? whole.substr(prefix.size()) : whole;
  Board board;
  board.square_mm = square_mm;
  const char* const end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, board.columns);
  const bool has_cross =
      first.ec == std::errc() && first.ptr != end && (*first.ptr == 'x' || *first.ptr == 'X');
  const auto second = has_cross ? std::from_chars(first.ptr + 1, end, board.rows) : first;
  if (is_charuco) {  // squares -> inner corners
    --board.columns;
    --board.rows;
    board.marker_mm = marker_mm.value_or(0.75 * square_mm);
  }
  if (!has_cross || second.ec != std::errc() || second.ptr != end || board.columns < 3 || board.rows < 3 ||
      board.columns > 100 || board.rows > 100)
    throw Error("'" + whole + "' is no board size", "--board",
                "give a chessboard's inner corners, 9x6 say, or a ChArUco board's squares, charuco:7x5");
  if (!(square_mm >= kLeastSquare_mm && square_mm <= kMostSquare_mm))
    throw Error(formatted("a square of %g mm is no size of a board", square_mm), "--square",
                "measure one and give it in mm, 25 say");
  if (is_charuco && !(*board.marker_mm > 0 && *board.marker_mm < square_mm))
    throw Error("the markers must be longer than 0 mm and smaller than the squares", "--marker");
  return board;
}

namespace {

/// Searches a small copy of the picture, and only if it looks like a board at all.
Corners detectAtOnce(const cv::Mat& image, const Board& board) {
  const double scale = std::min(1.0, double(kLive_px) / std::max(image.cols, image.rows));
  cv::Mat small = image;
  if (scale < 1) cv::resize(image, small, {}, scale, scale, cv::INTER_AREA);
  Corners corners = detect(small, board, kThorough | cv::CALIB_CB_FAST_CHECK);
  const auto offset = float(0.5 / scale - 0.5);
  for (auto& corner : corners) corner = corner * float(1 / scale) + cv::Point2f(offset, offset);
  return corners;
}

/// Refines corners to sub-pixel, in the order of the board.
Corners finished(const cv::Mat& image, const Board& board, Corners corners) {
  if (corners.empty()) return {};
  makeRightHanded(board, corners);
  refine(image, board, corners);
  const bool is_order_visible = (board.columns + board.rows) % 2 == 1;
  if (is_order_visible && !isFirstSquareBlack(image, corners, board))
    std::reverse(corners.begin(), corners.end());
  return corners;
}

SeenCorners withAllNumbers(Corners corners) {
  SeenCorners seen{std::move(corners), {}};
  for (int id = 0; id < int(seen.px.size()); ++id) seen.ids.push_back(id);
  return seen;
}

}  // namespace

std::vector<cv::Point2f> findCorners(const cv::Mat& image, const Board& board) {
  FACENAV_EXPECT(image.type() == CV_8U, "8-bit grey expected");
  return finished(image, board, detectQuickly(image, board));
}

SeenCorners findBoardAtOnce(const cv::Mat& image, const Board& board) {
  FACENAV_EXPECT(image.type() == CV_8U, "8-bit grey expected");
  if (board.isCharuco()) return findCharuco(image, board);
  return withAllNumbers(finished(image, board, detectAtOnce(image, board)));
}

std::vector<cv::Point3f> boardPoints(const Board& board) {
  std::vector<cv::Point3f> points;
  for (int r = 0; r < board.rows; ++r)
    for (int c = 0; c < board.columns; ++c)
      points.emplace_back(float(c * board.square_mm), float(r * board.square_mm), 0.f);
  return points;
}

std::vector<cv::Point3f> boardPoints(const Board& board, const std::vector<int>& ids) {
  const auto all = boardPoints(board);
  if (ids.empty()) return all;
  std::vector<cv::Point3f> points;
  for (const int id : ids) points.push_back(all[std::size_t(id)]);
  return points;
}

SeenCorners findBoard(const cv::Mat& image, const Board& board) {
  if (board.isCharuco()) return findCharuco(image, board);
  return withAllNumbers(findCorners(image, board));
}

}  // namespace facenav::cameras
