#pragma once
// StartFace: checks a stored rig at its start by a person's face. A few pairs in which both cameras see the
// face are matched without the rig and diagnosed (health/pair_diagnosis.h). A head that moves between two
// exposures looks like a camera that moved: only pairs of a face at rest are used, and only those that agree.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "facenav/face/face_landmarks.h"
#include "facenav/health/pair_diagnosis.h"
#include "facenav/health/verify_rig.h"

namespace facenav::steps {

class StartFace {
 public:
  /// Starts a check. `detector` null: no search for a face.
  StartFace(const cameras::StereoRig& rig, std::shared_ptr<const face::FaceDetector> detector);
  /// Adds a frame; call it in the order of their times, several a second. Processes one now and then; that
  /// takes a second if both cameras see a face, else tenths of one.
  void add(const cameras::StereoFrame& frame);
  /// State of the rig; unclear until enough pairs agree.
  health::RigState state() const;
  /// One line; empty while it is unclear.
  std::string words() const;
  bool isDone() const;

 private:
  struct Pair {
    health::PairDiagnosis diagnosis;
    double row_px = 0;  // median signed distance of a point from its row
  };
  static bool agree(const Pair& a, const Pair& b);
  bool seesFace(const cameras::StereoFrame& frame);
  bool isAtRest(const cameras::StereoFrame& frame) const;
  Pair diagnosed(const cameras::StereoFrame& frame) const;
  std::vector<const Pair*> agreeing() const;

  const cameras::StereoRig rig_;
  std::shared_ptr<const face::FaceDetector> detector_;
  std::vector<Pair> pairs_;
  cameras::StereoFrame before_;                      // the last frame
  std::optional<face::FaceLandmarks> left_, right_;  // of the last processed frame
  int looks_ = 0;
  std::optional<double> next_s_;  // time at which the next frame is processed
};

}  // namespace facenav::steps
