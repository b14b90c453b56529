#pragma once
// Checks a calibration from live pictures of the board, or of the coil's marker, in two places, because one
// place alone proves too little (verify_rig.h). A board is used only while it is still: two cameras without a
// trigger see a moving one at two moments.

#include <memory>

#include "facenav/health/verify_rig.h"
#include "facenav/setup/board_collector.h"
#include "facenav/setup/coil_setup.h"

namespace facenav::steps {

class RigCheckRun {
 public:
  RigCheckRun(const cameras::StereoRig& rig, const cameras::Board& board,
              const coil_tracking::CoilModel& coil, const CoilSetup::MakeTracker& make_tracker);
  /// Adds a frame and returns what it showed, for drawing.
  BoardSight add(const cameras::StereoFrame& frame);
  /// Result, when enough was seen: a fault in the first place, else both places.
  const std::optional<health::RigVerification>& result() const { return result_; }
  double progress() const;
  /// Measurements so far, once the first place is done; nothing before.
  std::optional<health::RigVerification> firstPlace() const;

 private:
  /// Numbers of frames in the first place and elsewhere.
  struct Places {
    int first = 0, second = 0;
    void add(const health::CheckMotion& motion) { motion.isEnough() ? ++second : ++first; }
  };
  void judge(const health::RigVerifier& verifier, const Places& places, int wanted);

  BoardCollector stillness_;  // only its test for rest is used, not its views
  health::RigVerifier board_, marker_;
  Places board_places_, marker_places_;
  int marker_frames_ = 0;
  std::optional<health::RigVerification> result_;
};

}  // namespace facenav::steps
