#pragma once
// CoilSetup: step 4 of the set-up. It checks that the coil's marker is recognised and measures the coil's
// pose on it, by pivoting: the coil's centre, then a point of the handle, then a point of the side rests on a
// fixed tip while the coil is turned about it (coil_tracking/coil_calibration.h). Alternatively a jig holds a
// second marker. Poses are collected automatically.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <functional>

#include "facenav/coil_tracking/coil_calibration.h"
#include "facenav/coil_tracking/coil_tracker.h"
#include "facenav/setup/shutter_wave.h"

namespace facenav::steps {

class CoilSetup {
 public:
  enum class Stage { look, centre, handle, side, jig, wave, done };
  using MakeTracker = std::function<std::unique_ptr<coil_tracking::CoilTracker>()>;

  CoilSetup(const cameras::StereoRig& rig, const coil_tracking::CoilModel& coil, MakeTracker make_tracker);
  ~CoilSetup();

  /// Adds a frame; tracks the marker and collects poses in the stages that need them.
  void add(const cameras::StereoFrame& frame);
  /// Starts pivoting, with the coil's centre on the tip.
  void startPivots();
  /// Starts the calibration by a jig, described as a coil.json with its marker's pose on the coil. A jig with
  /// the coil's own marker is refused in words().
  void startJig(const coil_tracking::CoilModel& jig);
  /// Measures the cameras' rolling shutter on the waved coil; optional.
  void startWave();
  void stop();

  Stage stage() const { return stage_; }
  bool isSeen() const { return is_seen_; }
  /// True if the jig's marker is seen, while the coil is calibrated with a jig.
  bool isJigSeen() const { return is_jig_seen_; }
  /// Wave since the last startWave(); kept while the coil is calibrated.
  const std::optional<ShutterWave>& wave() const { return wave_; }
  /// True if words() describe a fault.
  bool hasTrouble() const { return !trouble_.empty(); }
  /// Corners of the marker in the last frame, for drawing; empty: not seen.
  const std::vector<cv::Point2f>& leftCorners() const { return left_px_; }
  const std::vector<cv::Point2f>& rightCorners() const { return right_px_; }
  /// Progress of the running stage, 0..1.
  double progress() const;
  /// What to do, one sentence.
  std::string words() const;
  /// Result; set at the end.
  const std::optional<coil_tracking::CoilCalibration>& result() const { return result_; }

 private:
  void followJig(const coil_tracking::CoilResult& coil, const cameras::StereoFrame& frame);
  void lookForOthers(const cameras::StereoFrame& frame);
  bool isOwn(int marker) const;
  bool isPivoting() const {
    return stage_ == Stage::centre || stage_ == Stage::handle || stage_ == Stage::side;
  }
  std::string unseenWords() const;
  void take(const RigidTransform<Camera, Marker>& pose);
  void tryPivot();
  void tryJig();

  const cameras::StereoRig rig_;
  const coil_tracking::CoilModel coil_;
  MakeTracker make_tracker_;
  std::unique_ptr<coil_tracking::CoilTracker> tracker_, jig_tracker_;
  Stage stage_ = Stage::look;
  bool is_seen_ = false, is_jig_seen_ = false;
  std::optional<int> other_marker_;  // seen instead of the coil's: another coil is held
  double now_s_ = 0, turned_s_ = 0;  // time of the newest frame; time of the last new pose, or of the start
  std::optional<double> looked_for_others_s_;
  std::vector<cv::Point2f> left_px_, right_px_;
  std::vector<RigidTransform<Camera, Marker>> poses_;
  std::vector<coil_tracking::Pivot> pivots_;
  std::optional<coil_tracking::CoilModel> jig_;
  std::vector<coil_tracking::JigObservation> observations_;
  std::optional<ShutterWave> wave_;
  std::string trouble_;
  std::optional<coil_tracking::CoilCalibration> result_;
};

}  // namespace facenav::steps
