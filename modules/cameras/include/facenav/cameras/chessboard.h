#pragma once
// The printed chessboard or ChArUco board that calibrates a rig, and its corners found in an image. A ChArUco
// board (markers in the white squares) need not be seen whole: every corner knows its number.

#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <vector>

namespace facenav::cameras {

struct Board {
  int columns = 9, rows = 6;  // inner corners
  double square_mm = 25.0;
  std::optional<double> marker_mm = {};  // side of the markers: a ChArUco board
  std::string dictionary = "4x4_50";     // of its markers

  bool isCharuco() const { return marker_mm.has_value(); }
  int corners() const { return columns * rows; }
};

/// "9x6": a chessboard of 9 x 6 inner corners. "charuco:7x5": a ChArUco board of 7 x 5 squares, as OpenCV
/// counts them, with markers of 0.75 squares unless `marker_mm` says otherwise. Throws Error unless there are
/// at least 3 x 3 inner corners.
Board boardFromText(const std::string& text, double square_mm,
                    std::optional<double> marker_mm = std::nullopt);

/// Corners of one image with their numbers on the board, row by row from 0.
struct SeenCorners {
  std::vector<cv::Point2f> px;
  std::vector<int> ids;
};
/// A chessboard is found whole or not at all; of a ChArUco board at least 8 corners, not all in one row, are
/// found, or none. `image`: 8-bit grey.
SeenCorners findBoard(const cv::Mat& image, const Board& board);

/// The inner corners row by row, sub-pixel, in one order for all images where the colours allow (an odd and
/// an even side: the square inside the first four corners is black); empty when the whole board is not seen.
/// `image`: 8-bit grey. The window of the sub-pixel refinement follows the size of the squares in this image:
/// a fixed one would reach into the neighbouring corners of a small board or waste the edges of a large one.
std::vector<cv::Point2f> findCorners(const cv::Mat& image, const Board& board);

/// The corners' places on the board, mm, z = 0, same order.
std::vector<cv::Point3f> boardPoints(const Board& board);
/// Of these corners only; of all where `ids` is empty.
std::vector<cv::Point3f> boardPoints(const Board& board, const std::vector<int>& ids);

}  // namespace facenav::cameras
