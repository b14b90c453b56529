#pragma once
// RigMonitor: do the cameras still stand as they were calibrated? It needs no board. It gathers points that
// both images show (skin, marker corners) and squares of known size. The cameras have moved where a motion of
// the right camera explains these much better than the calibration's own uncertainty does.
//
// Generalised likelihood ratio: under "holds", epipolar residuals and size errors come from noise, from what
// the lens model leaves, and from the calibration's parameters, each as uncertain as it is known to be; under
// "moved", six parameters of the right camera's pose are free as well (as Hansen, Alismail, Rander, Browning
// 2012, "Online continuous stereo extrinsic parameter estimation", fit them). Points are gathered in cells of
// the image, so that ten thousand in one place do not pass for ten thousand independent ones: a cell counts
// by its median, and the cells by Student's t, since a match on a silhouette or a glint is off by pixels.
//
// What it sees: pitch and roll of one camera against the other from epipolar residuals (some hundredths of a
// degree). Yaw and a longer or shorter baseline move points along the epipolar lines and show only in the
// size of squares; a focal length that changed in both cameras alike shows in neither.

#include <array>
#include <map>
#include <string>
#include <vector>

#include "facenav/cameras/stereo_rig.h"

namespace facenav::cameras {

/// One point in both images, each place measured without regard to the epipolar line.
struct Correspondence {
  Eigen::Vector2d left_px, right_px;
  double sigma_px = 0.2;  // across the epipolar line
};

/// A square of known size (a marker), corners in order, in both images.
struct SquareSighting {
  std::array<Eigen::Vector2d, 4> left_px, right_px;
  double size_mm = 0;         // as printed
  double print_sigma_mm = 0;  // how well that is known
  double sigma_mm = 0;        // of the size in the images
};

/// The calibration's uncertainty: rigs one standard deviation away along independent directions. The
/// covariance of anything computed from the rig is the sum of the squares of its changes.
struct RigUncertainty {
  std::vector<StereoRig> one_sigma;
  double lens_px = 0.05;  // left by the lens model in one place of the image
};
/// From the rig's own covariance; where it has none, what is typical of its rms_px (0.2 px where unknown).
RigUncertainty uncertaintyOf(const StereoRig& rig);

struct RigVerdict {
  enum class State { unknown, holds, moved };
  State state = State::unknown;
  double statistic = 0;      // of the likelihood ratio; chi-square with 6 degrees of freedom if it holds
  double contradiction = 0;  // median over the points of |residual| in its own sigmas; 0.67 if it holds
  double epipolar_px = 0;    // rms over the cells, wrong matches left out
  double displaced_mm = 0;   // rms error of points in space if the cameras moved as estimated
  Eigen::Vector3d turn_rad = Eigen::Vector3d::Zero();  // of the right camera, as estimated

  bool hasMoved() const { return state == State::moved; }
  /// One line: "the cameras have moved since their calibration (..): calibrate again". Empty unless moved.
  std::string words() const;
};

class RigMonitor {
 public:
  explicit RigMonitor(const StereoRig& rig) : RigMonitor(rig, uncertaintyOf(rig)) {}
  RigMonitor(const StereoRig& rig, RigUncertainty uncertainty);

  /// Of one frame. Cheap: some microseconds a point.
  void add(const std::vector<Correspondence>& points);
  void add(const SquareSighting& square);
  /// About a millisecond: for every 30th frame, not for each.
  RigVerdict verdict() const;

 private:
  struct Cell {
    Eigen::Vector2d left_px = Eigen::Vector2d::Zero(), right_px = Eigen::Vector2d::Zero();
    std::vector<double> residuals_px, sigmas_px;
    std::size_t next = 0;  // the oldest, once the memory is full
  };
  struct SizeCell {
    SquareSighting square;
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
