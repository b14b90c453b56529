#pragma once
// calibrate: pairs of chessboard or ChArUco images -> StereoRig. Each camera alone gives the start (Zhang
// 2000). Then all parameters of both cameras and all board poses are fitted together (as cv::stereoCalibrate
// without fixed intrinsics). Beyond that:
// - views that disagree with the rest are left out and named, because one of them bends every parameter.
//   Wrong corners (one camera alone does not fit) are distinguished from boards that moved between the
//   exposures;
// - the distortion model is chosen by cross-validation. A fuller model always lowers the error on its own
//   views, so it is used only when it also lowers the error on views left out;
// - principal point, tangential terms and aspect have a prior, for views that do not determine them;
// - standard errors come from the differences between views. So two calibrations of one camera agree within
//   them. They do not include an error common to all views: the size of the printed squares.

#include <optional>
#include <string>
#include <vector>

#include "facenav/cameras/chessboard.h"
#include "facenav/cameras/head_effect.h"
#include "facenav/cameras/stereo_rig.h"
#include "facenav/core/task_monitor.h"

namespace facenav::cameras {

struct CalibrationPair {
  std::string name;     // name for the report: "left01.jpg, right01.jpg"
  cv::Mat left, right;  // 8-bit grey, all of one size
};

/// The corners of one CalibrationPair.
struct BoardView {
  std::string name;
  std::vector<cv::Point2f> left, right;
  std::vector<int> left_ids, right_ids;  // numbers of these corners on the board; empty: all, in order
};

struct ViewReport {
  std::string name;
  bool is_used = false;
  std::string reason;                               // reason why it is not used
  std::optional<double> left_rms_px, right_rms_px;  // against the final rig; nullopt: no board found
};

struct ModelReport {
  std::string name;            // "k1 k2 p1 p2", "k1 k2", "k1 k2 p1 p2 k3", "rational"
  double rms_px = 0;           // for the views of the fit
  double held_out_rms_px = 0;  // for views left out in turn
};

/// A parameter of the rig with its standard error (jackknife over the views).
struct ParameterError {
  std::string name;  // "left fx px", "right k1", "yaw deg", "baseline mm"
  double value = 0, sigma = 0;
};

struct Calibration {
  StereoRig rig;               // rms_px is set
  double rms_px = 0;           // sqrt(mean squared distance), all corners of all used views, left and right
  double held_out_rms_px = 0;  // of the chosen model
  double focal_sigma_px = 0, baseline_sigma_mm = 0;  // standard deviations of the fit
  std::vector<ParameterError> parameters;            // all parameters
  HeadEffect at_head;
  std::string model;
  std::vector<ModelReport> models;  // all models that were tried
  std::vector<ViewReport> views;    // all pairs, in the order given
  std::vector<std::string>
      warnings;  // "left and right look swapped", "the board never came near the corners", ..
  int usedViews() const;
};

/// Calibrates. Throws Error: no pairs, sizes differ, board found in too few of them, or too few views in
/// which the board did not move between the two exposures.
Calibration calibrate(const std::vector<CalibrationPair>& pairs, const Board& board, TaskMonitor& monitor);
/// Calibrates from corners already found.
Calibration calibrateCorners(const std::vector<BoardView>& views, const cv::Size& image_size,
                             const Board& board, TaskMonitor& monitor);

}  // namespace facenav::cameras
