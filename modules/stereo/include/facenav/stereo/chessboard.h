#pragma once
// The printed chessboard that calibrates a rig, and its corners found in an image.

#include <opencv2/core.hpp>
#include <string>
#include <vector>

namespace facenav::stereo {

struct Board {
  int columns = 9, rows = 6;  // inner corners
  double square_mm = 25.0;

  int corners() const { return columns * rows; }
};

/// "9x6" -> columns and rows. Throws Error unless both are at least 3.
Board boardFromText(const std::string& text, double square_mm);

/// The inner corners row by row, sub-pixel, in one order for all images where the colours allow (an odd and
/// an even side: the square inside the first four corners is black); empty when the whole board is not seen.
/// `image`: 8-bit grey. The window of the sub-pixel refinement follows the size of the squares in this image:
/// a fixed one would reach into the neighbouring corners of a small board or waste the edges of a large one.
std::vector<cv::Point2f> findCorners(const cv::Mat& image, const Board& board);

/// The corners' places on the board, mm, z = 0, same order.
std::vector<cv::Point3f> boardPoints(const Board& board);

}  // namespace facenav::stereo
