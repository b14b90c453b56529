#pragma once
// ChArUco boards, found by OpenCV's aruco module.

#include "facenav/cameras/chessboard.h"

namespace facenav::cameras {

/// Finds a ChArUco board as findBoard() does. Throws Error for an unknown dictionary, or one with too few
/// markers for the board.
SeenCorners findCharuco(const cv::Mat& image, const Board& board);

}  // namespace facenav::cameras
