#pragma once
// RigMonitor: do the cameras still stand as they were calibrated? It needs no board. It gathers points that
// both images show (skin, marker corners) and squares of known size. The cameras have moved where a motion of
// the right camera explains these much better than the calibration's own uncertainty does.
//
// Points are gathered in cells of the image, so that ten thousand in one place do not count as independent: a
// cell counts by its median. The cells have a Student's t likelihood, since a match on a silhouette or a
// glint is wrong by pixels.
//
// What it detects: pitch and roll of one camera against the other, from epipolar residuals (some hundredths
// of a degree). Yaw and a longer or shorter baseline move points along the epipolar lines: only the size of
// squares shows them. A focal length that changed equally in both cameras shows in neither.

#include <array>
#include <map>
#include <string>
#include <vector>

#include "facenav/cameras/stereo_rig.h"

namespace facenav::cameras {

/// One point in both images, each position measured without use of the epipolar line.
struct Correspondence {
  Eigen::Vector2d left_px, right_px;
  double sigma_px = 0.2;  // across the epipolar line
};

/// A square of known size (a marker), corners in order, in both images.
struct SquareObservation {
  std::array<Eigen::Vector2d, 4> left_px, right_px;
  double size_mm = 0;         // as printed
  double print_sigma_mm = 0;  // standard error of size_mm
  double sigma_mm = 0;        // of the size measured in the images
};

/// The calibration's uncertainty: rigs one standard deviation away along independent directions. The
/// covariance of anything computed from the rig is the sum of the squares of its changes.
struct RigUncertainty {
  std::vector<StereoRig> one_sigma;
  double lens_px = 0.05;  // misfit of the lens model in one place of the image
};
/// From the rig's own covariance. Without one, typical values for its rms_px (0.2 px where unknown).
RigUncertainty uncertaintyOf(const StereoRig& rig);

struct RigVerdict {
  enum class State { unknown, holds, moved };
  State state = State::unknown;
  double statistic = 0;      // of the likelihood ratio; chi-square with 6 degrees of freedom if it holds
  double contradiction = 0;  // median over the points of |residual| in its own sigmas; 0.67 if it holds
  double epipolar_px = 0;    // rms over the cells, wrong matches left out
  double displaced_mm = 0;   // rms error of points in space if the cameras moved as estimated
  Eigen::Vector3d turn_rad = Eigen::Vector3d::Zero();  // estimated rotation of the right camera

  bool hasMoved() const { return state == State::moved; }
  /// One line: "the cameras have moved since their calibration (..): calibrate again". Empty unless moved.
  std::string words() const;
};

class RigMonitor {
 public:
  explicit RigMonitor(const StereoRig& rig) : RigMonitor(rig, uncertaintyOf(rig)) {}
  RigMonitor(const StereoRig& rig, RigUncertainty uncertainty);

  /// Adds the points of one frame. Takes some microseconds a point.
  void add(const std::vector<Correspondence>& points);
  void add(const SquareObservation& square);
  /// Takes about a millisecond: call it for every 30th frame, not for each.
  RigVerdict verdict() const;

 private:
  struct Cell {
    Eigen::Vector2d left_px = Eigen::Vector2d::Zero(), right_px = Eigen::Vector2d::Zero();
    std::vector<double> residuals_px, sigmas_px;
    std::size_t next = 0;  // index of the oldest sample, once the memory is full
  };
  struct SizeCell {
    SquareObservation square;
    double error = 0, variance = 0, count = 0;
  };
  StereoRig rig_;
  RigUncertainty uncertainty_;
  std::map<std::array<int, 3>, Cell> cells_;  // column, row, depth
  std::map<std::array<int, 3>, SizeCell> size_cells_;
};

/// Signed distance (px) of the right pixel from the epipolar line of the left one, positive on the side to
/// which the right image moves when it is moved down in a level rig.
double epipolarResidual_px(const StereoRig& rig, const Eigen::Vector2d& left_px,
                           const Eigen::Vector2d& right_px);

}  // namespace facenav::cameras
