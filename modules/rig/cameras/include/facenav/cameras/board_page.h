#pragma once
// The chessboard as a page to print at true size (SVG, A4 landscape, with a ruler of 100 mm), and as a
// picture for a tablet, phone or second screen. White squares lie at the border, so that the outer squares
// keep an edge on white.

#include <filesystem>
#include <string>

#include "facenav/cameras/chessboard.h"

namespace facenav::cameras {

/// Page as SVG. Throws Error: a ChArUco board, or one that is larger than the page.
std::string boardPageSvg(const Board& board);
/// Writes the whole file or nothing.
void writeBoardPage(const Board& board, const std::filesystem::path& path);
/// Draws the board: 8-bit, 1 channel, squares of whole pixels, as large as fits, in the middle of a white
/// picture. `square_px`: receives the side of a square.
cv::Mat boardPicture(const Board& board, const cv::Size& size, int* square_px = nullptr);

}  // namespace facenav::cameras
