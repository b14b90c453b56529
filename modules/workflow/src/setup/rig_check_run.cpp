#include "rig_check_run.h"

#include <algorithm>

namespace facenav::workflow {
namespace {

constexpr int kBoardFrames = 6, kMarkerFrames = 15;  // that make a verdict

}  // namespace

RigCheckRun::RigCheckRun(const cameras::StereoRig& rig, const cameras::Board& board,
                         const coil_tracking::CoilModel& coil, const CoilSetup::MakeTracker& make_tracker)
    : stillness_(board, {rig.width_px, rig.height_px}),
      board_(rig, board, nullptr, coil),
      marker_(rig, std::nullopt, make_tracker(), coil) {}

BoardSight RigCheckRun::add(const cameras::StereoFrame& frame) {
  using State = BoardSight::State;
  const BoardSight sight = stillness_.add(frame);
  if (sight.state == State::taken || sight.state == State::known) {
    board_.add(frame);
    ++board_frames_;
  } else if (sight.state == State::none) {
    marker_.add(frame);
    marker_frames_ = marker_.result().marker_frames;
  }
  if (board_frames_ >= kBoardFrames)
    result_ = board_.result();
  else if (marker_frames_ >= kMarkerFrames && board_frames_ == 0)
    result_ = marker_.result();
  return sight;
}

double RigCheckRun::progress() const {
  return std::min(1.0,
                  std::max(double(board_frames_) / kBoardFrames, double(marker_frames_) / kMarkerFrames));
}

}  // namespace facenav::workflow
