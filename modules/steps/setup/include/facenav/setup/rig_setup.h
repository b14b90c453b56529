#pragma once
// RigSetup: the set-up of a camera pair in four steps, as a nurse does it: place the cameras, calibrate them
// with a board, check the calibration, calibrate the coil. It reads live cameras on its own thread; window
// and tests read latest(). Each step judges the newest pair and gives one sentence.

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

/// State for the window; constant once published.
struct SetupView {
  SetupStep step = SetupStep::place;
  std::shared_ptr<const cameras::StereoFrame> frame;  // null: none yet
  std::string sentence;                               // what to do, or what was found
  bool is_done = false;                               // the step is complete
  bool needs_repair = false;                          // check: the calibration is no longer valid
  std::vector<SetupLine> lines;
  std::vector<cv::Point2f> left_marks, right_marks;  // corners of board or coil marker, px
  std::optional<cv::Rect> left_box, right_box;       // faces, px
  int views = 0;
  double progress = 0;  // of the step, 0..1
  std::optional<BoardCoverage> coverage;
  std::string failure;  // why no pictures arrive; empty: they arrive
};

struct SetupOptions {
  cameras::Board board{9, 6, 25.0};
  double distance_mm = 600;                    // of the target, to compute the uncertainty
  double good_mm = 1.0;                        // sufficient uncertainty, one standard deviation
  std::optional<cameras::StereoRig> rig = {};  // known already: a stored rig is checked again
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

  /// Newest view; never null. Callable from any thread.
  std::shared_ptr<const SetupView> latest() const;

  // Orders to the thread; a later view shows their effect.
  void go(SetupStep step);
  /// Sets another board; the views are taken anew.
  void useBoard(const cameras::Board& board);
  /// Calibrates from the present views; without this call, it happens as soon as they are enough.
  void finishViews();
  /// Takes further views after a calibration.
  void takeMoreViews();
  void repeatViews();
  void useCoil(const coil_tracking::CoilModel& coil);
  void startPivots();
  void startJig(const coil_tracking::CoilModel& jig);
  void startWave();

  // Results so far; nothing: not available yet.
  std::optional<cameras::StereoRig> rig() const;
  std::optional<capture::RigUncertainty_mm> uncertainty() const;
  std::optional<health::RigVerification> verification() const;
  std::optional<coil_tracking::CoilCalibration> coilCalibration() const;
  /// Row times of left and right camera, s from one row to the next, if the waved coil showed others than the
  /// rig's.
  std::optional<std::array<double, 2>> rowTimes_s() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace facenav::steps
