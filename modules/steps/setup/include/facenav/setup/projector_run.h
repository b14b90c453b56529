#pragma once
// ProjectorRun: the calibration of a projector with live cameras (stereo/projector_calibration.h): chooses
// the next picture to show, keeps the cameras' pair of each, and calibrates after each scene. One scene with
// depth (a face, a chair) is enough; of a plane, two at different distances are needed.

#include <optional>
#include <string>
#include <vector>

#include "facenav/cameras/stereo_frame.h"
#include "facenav/stereo/projector_calibration.h"

namespace facenav::steps {

class ProjectorRun {
 public:
  ProjectorRun(const cameras::StereoRig& rig, const stereo::ProjectorCode& code);

  /// Begins a scene. Nothing may move until it is recorded (24 pictures, some ten seconds).
  void startScene();
  bool isShowing() const { return next_ < pictures_.size(); }
  /// Picture that the projector must show now; only while isShowing().
  const cv::Mat& picture() const { return pictures_[next_]; }
  /// Notes that the picture was sent to the screen at `at_s` (steady clock).
  void shown(double at_s);
  /// Adds a current pair; the first one captured long enough after shown() is kept. The last pair of a scene
  /// takes a second or two: it is decoded, and the projector calibrated.
  void add(const cameras::StereoFrame& frame);
  /// Ends the scene, with a message, if the cameras have given no pair for some seconds. `now_s`: steady
  /// clock.
  void wait(double now_s);
  double progress() const;

  /// Result or what to do, one sentence.
  const std::string& words() const { return words_; }
  const std::optional<stereo::ProjectorCalibration>& result() const { return result_; }

 private:
  void finishScene();
  void useScene(const std::vector<stereo::LitPlace>& found);

  const cameras::StereoRig rig_;
  const stereo::ProjectorCode code_;
  const std::vector<cv::Mat> pictures_;
  std::size_t next_;  // index into pictures_; its size: none is shown
  std::optional<double> shown_s_;
  std::vector<cv::Mat> left_, right_;
  std::vector<stereo::LitPlace> places_;
  std::string words_;
  std::optional<stereo::ProjectorCalibration> result_;
};

}  // namespace facenav::steps
