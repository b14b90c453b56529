#pragma once
// ProjectorRun: the calibration of a projector with live cameras (stereo/projector_calibration.h): which
// picture it shows next, the cameras' pair of each, and the calibration after each scene. A scene with depth
// (a face, a chair) is enough; of a plane, two at different distances.

#include <optional>
#include <string>
#include <vector>

#include "facenav/cameras/stereo_frame.h"
#include "facenav/stereo/projector_calibration.h"

namespace facenav::steps {

class ProjectorRun {
 public:
  ProjectorRun(const cameras::StereoRig& rig, const stereo::ProjectorCode& code);

  /// Begins a scene. Nothing may move until it is taken (24 pictures, some ten seconds).
  void startScene();
  bool isShowing() const { return next_ < pictures_.size(); }
  /// What the projector must show now. Only while isShowing().
  const cv::Mat& picture() const { return pictures_[next_]; }
  /// It was handed to the screen at `at_s` (steady clock).
  void shown(double at_s);
  /// A pair of now; the first one that was taken long enough after shown() is kept. The last pair of a scene
  /// takes a second or two: it is decoded, and the projector calibrated.
  void add(const cameras::StereoFrame& frame);
  /// Ends the scene, and says so, where the cameras have given no pair for some seconds. `now_s`: steady
  /// clock.
  void wait(double now_s);
  double progress() const;

  /// What was found or what to do, one sentence.
  const std::string& words() const { return words_; }
  const std::optional<stereo::ProjectorCalibration>& result() const { return result_; }

 private:
  void finishScene();
  void useScene(const std::vector<stereo::LitPlace>& found);

  const cameras::StereoRig rig_;
  const stereo::ProjectorCode code_;
  const std::vector<cv::Mat> pictures_;
  std::size_t next_;  // of pictures_; its size: none is shown
  std::optional<double> shown_s_;
  std::vector<cv::Mat> left_, right_;
  std::vector<stereo::LitPlace> places_;
  std::string words_;
  std::optional<stereo::ProjectorCalibration> result_;
};

}  // namespace facenav::steps
