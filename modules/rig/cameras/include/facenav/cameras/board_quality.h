#pragma once
// Quality of a picture of the calibration board: blur and light, measured at the edges between its squares.

#include "facenav/cameras/chessboard.h"

namespace facenav::cameras {

struct BoardQuality {
  double edge_px = 0;                     // width of an edge, 20 to 80 % of its height; median over the edges
  double white_grey = 0, black_grey = 0;  // median grey in the middle of white and of black squares
  double square_px = 0;                   // median distance of neighbouring corners
  bool hasContrast() const { return white_grey - black_grey > 1; }
};

/// Measures the quality. `seen`: as found in `image` (8-bit grey).
BoardQuality boardQuality(const cv::Mat& image, const SeenCorners& seen, const Board& board);

}  // namespace facenav::cameras
