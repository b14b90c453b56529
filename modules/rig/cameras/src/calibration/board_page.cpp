#include "facenav/cameras/board_page.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "facenav/core/whole_file.h"

namespace facenav::cameras {
namespace {

constexpr double kPageWidth_mm = 297, kPageHeight_mm = 210, kRuler_mm = 100, kPageMargin_mm = 8;

void requireChessboard(const Board& board) {
  if (board.isCharuco()) throw Error("a ChArUco board is not drawn here", "", "use a chessboard, 9x6 say");
}

/// True for black squares. As findCorners expects, the one inside the first four corners is black.
bool isBlackSquare(int column, int row) { return (column + row) % 2 == 0; }

}  // namespace

std::string boardPageSvg(const Board& board) {
  requireChessboard(board);
  const double side = board.square_mm, width = (board.columns + 1) * side, height = (board.rows + 1) * side;
  if (width > kPageWidth_mm - 2 * kPageMargin_mm || height > kPageHeight_mm - 3 * kPageMargin_mm)
    throw Error(formatted("a board of %.0f x %.0f mm does not fit on A4", width, height), "--square",
                "choose smaller squares");
  const double left = (kPageWidth_mm - width) / 2, top = kPageMargin_mm;
  std::string svg = formatted(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%gmm\" height=\"%gmm\" viewBox=\"0 0 %g %g\">\n"
      "<rect width=\"100%%\" height=\"100%%\" fill=\"white\"/>\n",
      kPageWidth_mm, kPageHeight_mm, kPageWidth_mm, kPageHeight_mm);
  for (int r = 0; r <= board.rows; ++r)
    for (int c = 0; c <= board.columns; ++c)
      if (isBlackSquare(c, r))
        svg += formatted("<rect x=\"%.4f\" y=\"%.4f\" width=\"%.4f\" height=\"%.4f\"/>\n", left + c * side,
                         top + r * side, side, side);
  const double y = kPageHeight_mm - kPageMargin_mm;
  svg +=
      formatted("<path d=\"M%g %gv-3v1.5h%gv-1.5v3\" fill=\"none\" stroke=\"black\" stroke-width=\"0.3\"/>\n",
                left, y, kRuler_mm);
  svg += formatted(
      "<text x=\"%g\" y=\"%g\" font-size=\"4\" font-family=\"sans-serif\">100 mm: measure this line. Board "
      "%dx%d, squares %g mm. Glue it on a flat plate.</text>\n</svg>\n",
      left + kRuler_mm + 4, y, board.columns, board.rows, board.square_mm);
  return svg;
}

void writeBoardPage(const Board& board, const std::filesystem::path& path) {
  writeWholeFile(path, boardPageSvg(board), FileAccess::by_umask);
}

cv::Mat boardPicture(const Board& board, const cv::Size& size, int* square_px) {
  requireChessboard(board);
  // Leaves half a square of white all around.
  const int side = std::min(size.width / (board.columns + 2), size.height / (board.rows + 2));
  if (side < 4) throw Error("the picture is too small for the board", "", "use a larger screen");
  if (square_px) *square_px = side;
  cv::Mat picture(size, CV_8U, cv::Scalar(255));
  const cv::Point origin((size.width - (board.columns + 1) * side) / 2,
                         (size.height - (board.rows + 1) * side) / 2);
  for (int r = 0; r <= board.rows; ++r)
    for (int c = 0; c <= board.columns; ++c)
      if (isBlackSquare(c, r))
        picture(cv::Rect(origin.x + c * side, origin.y + r * side, side, side)).setTo(0);
  return picture;
}

}  // namespace facenav::cameras
