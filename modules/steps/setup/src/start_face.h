#pragma once
// StartFace: what a person's face says about a kept rig at its start. A few pairs in which both cameras see
// the face are matched without the rig and diagnosed (health/pair_diagnosis.h). A head that moves between
// two exposures looks like a camera that moved: only pairs of a face at rest count, and only those that
// agree.

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
  /// `detector` null: no face is looked for.
  StartFace(const cameras::StereoRig& rig, std::shared_ptr<const face::FaceDetector> detector);
  /// Frames in the order of their times, several a second. Looks at one now and then; that takes a second
  /// where both cameras see a face, else tenths of one.
  void add(const cameras::StereoFrame& frame);
  /// Unclear until enough pairs agree.
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
  std::optional<face::FaceLandmarks> left_, right_;  // of the last frame that was looked at
  int looks_ = 0;
  std::optional<double> next_s_;  // when the next frame is looked at
};

}  // namespace facenav::steps
