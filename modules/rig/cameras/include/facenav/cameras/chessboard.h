#pragma once
// The printed chessboard or ChArUco board that calibrates a rig, and the search for its corners in an image.
// A ChArUco board (markers in the white squares) may be partly visible: every corner has a number.

#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <vector>

namespace facenav::cameras {

struct Board {
  int columns = 9, rows = 6;  // inner corners
  double square_mm = 25.0;
  std::optional<double> marker_mm = {};  // side of the markers; nullopt: a chessboard
  std::string dictionary = "4x4_50";     // of its markers

  bool isCharuco() const { return marker_mm.has_value(); }
  int corners() const { return columns * rows; }
};

/// Parses "9x6": a chessboard of 9 x 6 inner corners. "charuco:7x5": a ChArUco board of 7 x 5 squares, as
/// OpenCV counts them, with markers of `marker_mm` (default 0.75 squares). Throws Error unless there are at
/// least 3 x 3 inner corners.
Board boardFromText(const std::string& text, double square_mm,
                    std::optional<double> marker_mm = std::nullopt);

/// Corners in one image with their numbers on the board, row by row from 0.
struct SeenCorners {
  std::vector<cv::Point2f> px;
  std::vector<int> ids;
};
/// Finds a board. A chessboard is found whole or not at all; of a ChArUco board, at least 8 corners that are
/// not all in one row, or none. `image`: 8-bit grey.
SeenCorners findBoard(const cv::Mat& image, const Board& board);
/// Finds a board in live pictures: some 10 ms if there is no board (findBoard: up to a second), but misses
/// boards that are small or strongly tilted.
SeenCorners findBoardAtOnce(const cv::Mat& image, const Board& board);

/// Finds the inner corners row by row, sub-pixel; empty if the whole board is not visible. The order is the
/// same in all images where the colours define it (an odd and an even side: the square inside the first four
/// corners is black). `image`: 8-bit grey. The window of the sub-pixel refinement follows the size of the
/// squares in this image: a fixed window would include neighbouring corners of a small board, or use too
/// little of the edges of a large one.
std::vector<cv::Point2f> findCorners(const cv::Mat& image, const Board& board);

/// Positions of all corners on the board, mm, z = 0, same order.
std::vector<cv::Point3f> boardPoints(const Board& board);
/// Positions of the corners `ids`; of all if `ids` is empty.
std::vector<cv::Point3f> boardPoints(const Board& board, const std::vector<int>& ids);

}  // namespace facenav::cameras
