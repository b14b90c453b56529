#include <algorithm>
#include <cmath>

#include "facenav/core/number_text.h"
#include "searches.h"

namespace facenav::stimulation {
namespace {

constexpr int kEnough = 5, kOf = 10;

/// The current level and its answers so far.
class Levels {
 public:
  explicit Levels(const ThresholdRules& rules) : rules_(rules), level_(rules.first_pct) {}

  void add(const ThresholdAnswer& answer) {
    if (is_done_ || std::abs(answer.intensity_pct - level_) > 0.5) return;
    ++(answer.has_response ? hits_ : misses_);
    is_rising_ ? rise() : descend();
  }

  ThresholdState state() const {
    ThresholdState state;
    state.estimate_pct = passed_;
    state.is_above_output = is_done_ && !passed_;
    if (is_done_) return state;
    state.next_pct = level_;
    state.level = formatted("at %.0f %%: %d with a response, %d without", level_, hits_, misses_);
    return state;
  }

 private:
  bool isAtFullOutput() const { return level_ >= kFullOutput_pct; }
  bool isPassed() const { return hits_ >= kEnough; }
  bool isFailed() const { return misses_ > kOf - kEnough; }

  void goTo(double level) {
    level_ = std::clamp(level, 1.0, kFullOutput_pct);
    hits_ = misses_ = 0;
  }

  void rise() {
    const bool is_sure = misses_ == 0 && hits_ >= rules_.sure_responses;
    if (is_sure || (isAtFullOutput() && isPassed())) return beginDescent();
    if (isAtFullOutput())
      is_done_ = isFailed();  // no level above: the rule decides here
    else if (misses_ > 0)
      goTo(level_ + rules_.rise_pct);
  }

  void beginDescent() {
    is_rising_ = false;
    passed_ = level_;
    goTo(level_ - rules_.descent_pct);
  }

  void descend() {
    is_done_ = isFailed();
    if (!isPassed()) return;
    passed_ = level_;
    is_done_ = level_ <= rules_.descent_pct;
    if (!is_done_) goTo(level_ - rules_.descent_pct);
  }

  const ThresholdRules& rules_;
  double level_;
  int hits_ = 0, misses_ = 0;
  bool is_rising_ = true, is_done_ = false;
  std::optional<double> passed_;  // the lowest level passed so far
};

}  // namespace

ThresholdState fiveOfTenAfter(const std::vector<ThresholdAnswer>& answers, const ThresholdRules& rules) {
  Levels levels(rules);
  for (const auto& answer : answers) levels.add(answer);
  return levels.state();
}

}  // namespace facenav::stimulation
