#pragma once
// RigVerifier: checks whether a rig's calibration still holds. Stereo frames of something of known size (the
// board in a new position, or the coil's marker) are measured with the calibration and compared with the
// truth: lengths, rows (epipolar lines), and each camera's own picture of the board. Lengths are needed
// because rows alone do not show a camera that turned sideways. In one place, a turn and a shift of a camera
// can cancel each other: a second place, nearer or farther, separates them.

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "facenav/cameras/chessboard.h"
#include "facenav/cameras/stereo_frame.h"
#include "facenav/core/setting.h"
#include "facenav/health/rig_monitor.h"

namespace facenav::health {

struct RigCheckRules {
  static constexpr const char* kModule = "workflow";
  static constexpr const char* kSubject = "check of a camera pair";

  double least_moved_mm = 100, least_turned_deg = 20;

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor(kMotion("least_moved_mm", 0, 1000, "mm",
                    "board or marker moves at least so far between measurements"),
            self.least_moved_mm);
    visitor(kMotion("least_turned_deg", 0, 90, "deg", "or turns at least so far"), self.least_turned_deg);
  }

  static constexpr Evidence kMotion{Origin::chosen,
                                    "by judgement: a hand's width; at 600 mm, 100 mm of distance leave a "
                                    "sixth of what a turn and a shift of a "
                                    "camera that cancel each other in one place do to a length"};
};

/// One length, measured in all frames.
struct MeasuredLength {
  std::string what;  // "board", "marker"
  double true_mm = 0, measured_mm = 0;
  double sigma_mm = 0;  // of the difference, if the calibration holds: calibration, print and pictures
  bool contradicts() const;
  /// One line: "board: 160.03 mm measured, 160.00 mm true: +0.03 mm, +0.02 % (+-0.3 mm if the calibration
  /// holds)".
  std::string words() const;
};

/// Motion of board or marker between two measurements.
struct CheckMotion {
  double moved_mm = 0, turned_deg = 0;  // of its middle; of its normal
  /// True if, by RigCheckRules, the measurements are of two places.
  bool isEnough() const;
  std::string words() const;
};

/// The board's length does not fit although the rows do: the size given for its squares may be wrong. A
/// camera that turned sideways looks the same at one distance; the farther the board, the more it changes the
/// length.
struct SquareDoubt {
  double given_mm = 0, fitting_mm = 0;  // side of one square: as given; as the calibration measures it
  bool is_same_everywhere = false;      // the lengths are off by one factor at different distances
  /// What to check, one sentence.
  std::string words() const;
};

struct RigVerification {
  RigState state = RigState::unclear;
  int frames = 0, board_frames = 0, marker_frames = 0;
  std::vector<MeasuredLength> lengths;
  double row_error_px = 0;                     // median distance of a point from its epipolar line
  double left_lens_px = 0, right_lens_px = 0;  // rms of each camera's own picture of the board; 0: no board
  double scale_change = 0;  // relative scale of one camera's picture: other than 0 if its focal length is not
                            // the calibrated one
  double turn_deg = 0, shift_mm = 0;  // motion of the right camera since the calibration; 0 while it holds
  double point_error_mm = 0;          // effect of the motion on a point's position
  std::optional<SquareDoubt> square_doubt;
  CheckMotion motion;  // largest motion from the first measurement
  /// Findings with numbers, one line each: "board: 159.6 mm measured, 160.0 mm true (+-0.3 mm)".
  std::vector<std::string> findings() const;
  /// Verdict and advice, one line.
  std::string words() const;
};

/// Finds a square of known size in a frame (coil_tracking::squareFinder: the coil's marker); nullopt if it is
/// not seen well. Frames come in the order of their times.
using SquareFinder = std::function<std::optional<SquareObservation>(const cameras::StereoFrame&)>;

class RigVerifier {
 public:
  /// `board`: to look for; nullopt: a marker only. `find_marker`: may be empty (board only).
  RigVerifier(const cameras::StereoRig& rig, std::optional<cameras::Board> board, SquareFinder find_marker);
  ~RigVerifier();
  /// Measures a frame. Throws Error if the pictures do not have the rig's size.
  void add(const cameras::StereoFrame& frame);
  RigVerification result() const;
  /// Motion from the first measurement to the newest.
  CheckMotion motion() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace facenav::health
