#pragma once
// RigSetup: the set-up of a camera pair in four steps, as a nurse does it: place the cameras, calibrate them
// with a board, check the calibration, calibrate the coil. It reads live cameras on its own thread; window
// and tests read latest(). Each step judges the newest pair and says one sentence.

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "facenav/capture/frame_source.h"
#include "facenav/capture/rig_store.h"
#include "facenav/health/verify_rig.h"
#include "facenav/setup/board_collector.h"
#include "facenav/setup/camera_placement.h"
#include "facenav/setup/coil_setup.h"

namespace facenav::steps {

enum class SetupStep { place, calibrate, check, coil };

struct SetupLine {
  bool is_good = false;
  std::string words;
};

/// What the window shows. Never changed once it is published.
struct SetupView {
  SetupStep step = SetupStep::place;
  std::shared_ptr<const cameras::StereoFrame> frame;  // null: none yet
  std::string sentence;                               // what to do, or what was found
  bool is_done = false;                               // the step has what it needs
  bool needs_repair = false;                          // check: the calibration does not hold
  std::vector<SetupLine> lines;
  std::vector<cv::Point2f> left_marks, right_marks;  // corners of board or coil marker, px
  std::optional<cv::Rect> left_box, right_box;       // faces, px
  int views = 0;
  double progress = 0;  // of the step, 0..1
  std::optional<BoardCoverage> coverage;
  std::string failure;  // why no more pictures come; empty: they come
};

struct SetupOptions {
  cameras::Board board{9, 6, 25.0};
  double distance_mm = 600;                    // of the target, for the stated uncertainty
  double good_mm = 1.0;                        // uncertainty that needs no more views, one standard deviation
  std::optional<cameras::StereoRig> rig = {};  // known already: a kept rig is checked again
  coil_tracking::CoilModel coil = coil_tracking::defaultCoil();
};

struct SetupMethods {
  std::shared_ptr<const face::FaceDetector> face_detector;
  CoilSetup::MakeTracker make_coil_tracker;
};

class RigSetup {
 public:
  RigSetup(std::unique_ptr<capture::FrameSource> source, const SetupOptions& options, SetupMethods methods);
  /// Waits for the frame that is being read.
  ~RigSetup();
  RigSetup(const RigSetup&) = delete;
  RigSetup& operator=(const RigSetup&) = delete;

  /// Never null. From any thread.
  std::shared_ptr<const SetupView> latest() const;

  // Orders to the thread; what they change shows in a later view.
  void go(SetupStep step);
  /// Another board: the views are taken anew.
  void useBoard(const cameras::Board& board);
  /// Calibrates from the views that are there; else it is done as soon as they are enough.
  void finishViews();
  /// Takes further views after a calibration.
  void takeMoreViews();
  void repeatViews();
  void useCoil(const coil_tracking::CoilModel& coil);
  void startPivots();
  void startJig(const coil_tracking::CoilModel& jig);
  void startWave();

  // Results so far; nothing: not there yet.
  std::optional<cameras::StereoRig> rig() const;
  std::optional<capture::RigUncertainty_mm> uncertainty() const;
  std::optional<health::RigVerification> verification() const;
  std::optional<coil_tracking::CoilCalibration> coilCalibration() const;
  /// Left and right, s from one row to the row below, where the waved coil showed others than the rig states.
  std::optional<std::array<double, 2>> rowTimes_s() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace facenav::steps
