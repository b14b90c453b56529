#pragma once
// The check of a calibration from live pictures: the board in a new position, or the coil's marker. A board
// counts only while it stands still: two cameras without a trigger see a moving one at two moments.

#include <memory>

#include "facenav/workflow/board_collector.h"
#include "facenav/workflow/coil_setup.h"
#include "facenav/workflow/verify_rig.h"

namespace facenav::workflow {

class RigCheckRun {
 public:
  RigCheckRun(const cameras::StereoRig& rig, const cameras::Board& board,
              const coil_tracking::CoilModel& coil, const CoilSetup::MakeTracker& make_tracker);
  /// What the frame showed, for drawing.
  BoardSight add(const cameras::StereoFrame& frame);
  /// When enough was seen.
  const std::optional<RigVerification>& result() const { return result_; }
  double progress() const;

 private:
  BoardCollector stillness_;  // views are of no interest here
  RigVerifier board_, marker_;
  int board_frames_ = 0, marker_frames_ = 0;
  std::optional<RigVerification> result_;
};

}  // namespace facenav::workflow
