#pragma once
// RigMonitor: tests without a board whether the cameras are positioned as calibrated. It gathers points that
// both images show (skin, marker corners) and squares of known size. The cameras have moved if a motion of
// the right camera explains these much better than the calibration's own uncertainty does.
//
// Points are gathered in cells of the image, so that ten thousand in one place do not count as independent: a
// cell counts by its median. The cells have a Student's t likelihood, since a match on a silhouette or a
// glint is wrong by pixels.
//
// It detects pitch and roll of one camera against the other, from epipolar residuals (some hundredths of a
// degree). Yaw and a longer or shorter baseline move points along the epipolar lines: only the size of
// squares shows them. A focal length that changed equally in both cameras shows in neither.

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "facenav/cameras/rig_uncertainty.h"
#include "facenav/health/observation.h"
#include "facenav/health/rig_state.h"

namespace facenav::health {

/// Least likelihood ratio (-2 log) of a moved rig: chi-square with 6 degrees of freedom at the probability of
/// three standard errors. A higher value gives fewer false alarms and misses more motion. Evidence:
/// resources/doc/evidence.md.
constexpr double kMovedStatistic = 20;
/// Frames in a row that change a verdict: a single one may show a hand before the face or the marker.
constexpr int kFramesInARow = 5;

/// Estimate from the gathered points and squares.
struct RigEstimate {
  RigState state = RigState::unclear;  // unclear, holds or moved
  double statistic = 0;     // likelihood ratio; chi-square with 6 degrees of freedom if the calibration holds
  double epipolar_px = 0;   // rms over the cells, without wrong matches
  double displaced_mm = 0;  // rms error of points in space if the cameras moved as estimated
  Eigen::Vector3d turn_rad = Eigen::Vector3d::Zero();  // estimated rotation of the right camera

  bool hasMoved() const { return state == RigState::moved; }
  /// Verdict with numbers: "the cameras have moved since their calibration (..): calibrate again".
  RigVerdict verdict() const;
};

class RigMonitor {
 public:
  explicit RigMonitor(const cameras::StereoRig& rig) : RigMonitor(rig, cameras::uncertaintyOf(rig)) {}
  RigMonitor(const cameras::StereoRig& rig, cameras::RigUncertainty uncertainty);

  /// Adds the points of one frame. Takes some microseconds a point.
  void add(const std::vector<Correspondence>& points);
  void add(const SquareObservation& square);
  /// Estimates. Takes about a millisecond: call it for every 30th frame, not for each.
  RigEstimate estimate() const;

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
  class Evaluation;
  cameras::StereoRig rig_;
  cameras::RigUncertainty uncertainty_;
  std::map<std::array<int, 3>, Cell> cells_;  // column, row, depth
  std::map<std::array<int, 3>, SizeCell> size_cells_;
};

}  // namespace facenav::health
