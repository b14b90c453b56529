#include "rig_check_run.h"

#include <algorithm>

namespace facenav::steps {
namespace {

constexpr int kBoardFrames = 4, kMarkerFrames = 12;  // in each of the two places
constexpr int kUnclearTimes = 4;  // an unclear result is reported after this multiple of one place's frames

double shareOf(int frames, int wanted) { return std::min(1.0, double(frames) / wanted); }

}  // namespace

RigCheckRun::RigCheckRun(const cameras::StereoRig& rig, const cameras::Board& board,
                         const coil_tracking::CoilModel& coil, const CoilSetup::MakeTracker& make_tracker)
    : stillness_(board, {rig.width_px, rig.height_px}),
      board_(rig, board, nullptr),
      marker_(rig, std::nullopt, coil_tracking::squareFinder(make_tracker(), rig, coil)) {}

void RigCheckRun::judge(const health::RigVerifier& verifier, const Places& places, int wanted) {
  if (places.first + places.second < wanted) return;
  const health::RigVerification now = verifier.result();
  const bool is_unclear =
      now.state == health::RigState::unclear && places.first + places.second >= kUnclearTimes * wanted;
  const bool has_two_places = places.first >= wanted && places.second >= wanted;
  if (health::isFault(now.state) || is_unclear || (has_two_places && now.state == health::RigState::holds))
    result_ = now;
}

BoardSight RigCheckRun::add(const cameras::StereoFrame& frame) {
  using State = BoardSight::State;
  const BoardSight sight = stillness_.add(frame);
  if (sight.state == State::taken || sight.state == State::known) {
    board_.add(frame);
    board_places_.add(board_.motion());
    judge(board_, board_places_, kBoardFrames);
  } else if (sight.state == State::none) {
    marker_.add(frame);
    const int seen = marker_.result().marker_frames;
    if (seen > marker_frames_) marker_places_.add(marker_.motion());
    marker_frames_ = seen;
    if (board_places_.first == 0) judge(marker_, marker_places_, kMarkerFrames);
  }
  return sight;
}

std::optional<health::RigVerification> RigCheckRun::firstPlace() const {
  if (board_places_.first >= kBoardFrames) return board_.result();
  if (marker_places_.first >= kMarkerFrames) return marker_.result();
  return std::nullopt;
}

double RigCheckRun::progress() const {
  const auto of = [](const Places& places, int wanted) {
    return 0.5 * (shareOf(places.first, wanted) + shareOf(places.second, wanted));
  };
  return std::max(of(board_places_, kBoardFrames), of(marker_places_, kMarkerFrames));
}

}  // namespace facenav::steps
