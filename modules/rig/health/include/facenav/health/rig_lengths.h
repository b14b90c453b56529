#pragma once
// Scale and row errors of a rig from one stereo pair of a board or a marker.

#include <cmath>
#include <optional>
#include <vector>

#include "facenav/cameras/chessboard.h"
#include "facenav/cameras/rig_uncertainty.h"
#include "facenav/health/observation.h"

namespace facenav::health {

/// Relative standard error of a board's printed size, measured by ruler.
constexpr double kBoardPrint = 0.001;

/// Corners of a board that both pictures show, in the same order.
struct BoardPair {
  std::vector<cv::Point2f> left_px, right_px;
  std::vector<cv::Point3f> board_mm;
  std::vector<int> ids;
};
/// Finds the board; nullopt unless both pictures show at least 8 corners in common.
std::optional<BoardPair> findBoardPair(const cv::Mat& left, const cv::Mat& right,
                                       const cameras::Board& board);
std::vector<Correspondence> correspondences(const BoardPair& pair);
/// Largest square of the board whose corners are seen.
std::optional<SquareObservation> squareOf(const BoardPair& pair, const cameras::Board& board,
                                          const cameras::StereoRig& rig);

BoardPair exchanged(BoardPair pair);
SquareObservation exchanged(SquareObservation marker);
/// Measured divided by true length; NaN if the pair cannot be measured.
double lengthRatio(const BoardPair& pair, const cameras::StereoRig& rig);
double lengthRatio(const SquareObservation& marker, const cameras::StereoRig& rig);
/// Standard error of a ratio from the calibration alone.
template <class Seen>
double calibrationSigma(const Seen& seen, const cameras::StereoRig& rig) {
  double squares = 0;
  for (const auto& other : cameras::uncertaintyOf(rig).one_sigma)
    squares += std::pow(lengthRatio(seen, other) - lengthRatio(seen, rig), 2);
  return std::sqrt(squares);
}

/// Pose of the board before one camera by that camera's picture alone, with the rms of the fit, px.
struct SingleView {
  Eigen::Isometry3d camera_T_board = Eigen::Isometry3d::Identity();
  double rms_px = 0;
};
/// Scale of the board in the right picture relative to the prediction from the left one and the rig, minus 1.
/// A camera that turned leaves it 0; one whose focal length changed by 2 % shows 0.02.
double scaleChange(const SingleView& left, const SingleView& right, const cameras::StereoRig& rig);
SingleView fitBoard(const cameras::CameraModel& camera, const std::vector<cv::Point2f>& px,
                    const std::vector<cv::Point3f>& board_mm);

}  // namespace facenav::health
