#include "time_keeper.h"

#include <algorithm>

namespace facenav::session {
namespace {

constexpr double kEach_s = 5.0;         // between two writes
constexpr double kStateHolds_s = 0.25;  // as SessionOptions::age_limit_s: an older state is not shown
constexpr double kBreak_s = 1.0;        // without a frame that long the session was not guided

}  // namespace

TimeKeeper::TimeKeeper(const std::filesystem::path& session_folder, std::optional<double> idle_s)
    : folder_(session_folder) {
  if (!idle_s) return;
  earlier_ = casefile::readSessionTimes(folder_).value_or(casefile::SessionTimes{});
  earlier_.away_s += *idle_s;
}

void TimeKeeper::follow(const NavigationState& state, bool is_paused) {
  if (state.frame < 0) return;
  if (last_ && last_state_ && state.taken - *last_ > 0) {
    const double step_s = state.taken - *last_, known_s = std::min(step_s, kStateHolds_s);
    auto& guided = now_.guided;
    (*last_state_ == guidance::State::on_target ? guided.on_target_s
     : *last_state_ == guidance::State::adjust  ? guided.adjust_s
                                                : guided.lost_s) += known_s;
    if (step_s < kBreak_s) guided.lost_s += step_s - known_s;
  }
  last_ = state.taken;
  last_state_.reset();
  if (!is_paused && !state.target.empty()) last_state_ = state.guidance.state;
}

void TimeKeeper::keep(double running_s, double paused_s, bool is_last) {
  const Timestamp now = Timestamp::now();
  if (!is_last && kept_ && now - *kept_ < kEach_s) return;
  casefile::SessionTimes all = earlier_;
  all.running_s += running_s;
  all.paused_s += paused_s;
  all.guided.on_target_s += now_.guided.on_target_s;
  all.guided.adjust_s += now_.guided.adjust_s;
  all.guided.lost_s += now_.guided.lost_s;
  casefile::writeSessionTimes(all, folder_);
  kept_ = now;
}

}  // namespace facenav::session
