// facenav rig new with a board before live cameras: views are taken automatically.

#include <cstdio>

#include "commands/rig_steps.h"
#include "facenav/capture/calibration_images.h"
#include "facenav/core/log.h"
#include "facenav/core/number_text.h"
#include "facenav/setup/board_collector.h"

namespace facenav::app {
namespace {

/// Prints each prompt once.
class Prompter {
 public:
  explicit Prompter(bool is_quiet) : is_quiet_(is_quiet) {}
  void say(const std::string& words) {
    if (is_quiet_ || words == last_) return;
    last_ = words;
    std::fprintf(stderr, "%s\n", words.c_str());
  }

 private:
  bool is_quiet_;
  std::string last_;
};

void prompt(Prompter& prompter, const steps::BoardCollector& collector, const steps::BoardSight& sight) {
  using State = steps::BoardSight::State;
  if (sight.state == State::taken)
    prompter.say("view " + std::to_string(collector.views().size()) + " taken; " + collector.wish());
  else if (sight.state == State::refused || sight.state == State::one_side || sight.state == State::none)
    prompter.say(sight.reason);
}

void reportRefusals(const steps::BoardCollector& collector) {
  for (const auto& [reason, count] : collector.refusals())
    logWarning("left out, " + std::to_string(count) + " of the pairs: " + reason);
}

}  // namespace

cameras::Calibration calibrateLive(capture::FrameSource& source, const RigRequest& request,
                                   Context& context) {
  const cameras::Board board = boardOf(request).value();
  const cameras::StereoRig& size = source.rig();
  steps::BoardCollector collector(board, {size.width_px, size.height_px});
  Prompter prompter(context.is_quiet);
  prompter.say(collector.wish());
  const double until_s = Timestamp::now().s + request.within_s;
  while (!collector.isEnough() && Timestamp::now().s < until_s) {
    const auto frame = source.next();
    if (!frame) break;
    context.monitor.report("views", double(collector.views().size()) / 20.0);
    prompt(prompter, collector, collector.add(*frame));
  }
  if (!collector.isEnough())
    logWarning(
        formatted("%zu views only; still missing: %s", collector.views().size(), collector.wish().c_str()));
  return collector.calibrate(context.monitor);
}

cameras::Calibration calibrateChosen(const RigRequest& request, Context& context) {
  const auto pairs = capture::readCalibrationImages(request.left, request.right);
  const cameras::Board board = boardOf(request).value();
  steps::BoardCollector collector(board, pairs.front().left.size());
  for (const auto& pair : pairs) {
    const auto sight = collector.addStill(pair);
    if (!context.is_quiet && !sight.reason.empty())
      std::fprintf(stderr, "%s: %s\n", pair.name.c_str(), sight.reason.c_str());
  }
  reportRefusals(collector);
  return collector.calibrate(context.monitor);
}

}  // namespace facenav::app
