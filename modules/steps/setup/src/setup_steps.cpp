#include "setup_steps.h"

#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "facenav/core/settings_in_force.h"
#include "facenav/setup/settle_camera.h"

namespace facenav::steps {
namespace {

constexpr int kFewestSetupViews = 8;  // fewest views for finishViews()
constexpr double kUsualViews = 15.0;  // for the progress
constexpr const char* kCalibrateFirst = "calibrate the cameras first";

std::string checkWords(const BoardSight& sight, const std::optional<health::RigVerification>& first) {
  using State = BoardSight::State;
  if (first && (sight.state == State::taken || sight.state == State::known || sight.state == State::none))
    return formatted(
        "the first place fits: now move it nearer or farther, by %.0f mm at least, and hold it still",
        settingsOf<health::RigCheckRules>().least_moved_mm);
  switch (sight.state) {
    case State::none:
      return "hold the board in a new place, or the coil with its marker, before both cameras";
    case State::taken:
    case State::known:
      return "it is measured: hold it still";
    default:
      return sight.reason;
  }
}

std::vector<SetupLine> checkLines(const health::RigVerification& found) {
  std::vector<SetupLine> lines;
  for (const auto& length : found.lengths) lines.push_back({!length.contradicts(), length.words()});
  if (!found.lengths.empty()) lines.push_back({found.motion.isEnough(), found.motion.words()});
  return lines;
}

}  // namespace

SetupSteps::SetupSteps(const SetupOptions& options, SetupMethods methods, const cv::Size& size)
    : options_(options),
      methods_(std::move(methods)),
      size_(size),
      placement_(methods_.face_detector),
      collector_(options.board, size),
      is_calibrated_(options.rig.has_value()) {
  results_.rig = options.rig;
  if (options.rig) results_.uncertainty = uncertaintyAt(*options.rig, options.distance_mm);
}

SetupView SetupSteps::look(const std::shared_ptr<const cameras::StereoFrame>& frame, const Publish& publish) {
  SetupView now;
  now.step = step_;
  now.frame = frame;
  is_new_ = frame != seen_;
  seen_ = frame;
  switch (step_) {
    case SetupStep::place:
      place(now);
      break;
    case SetupStep::calibrate:
      collect(now, publish);
      break;
    case SetupStep::check:
      verify(now);
      break;
    case SetupStep::coil:
      followCoil(now);
      break;
  }
  return now;
}

bool SetupSteps::wantsFrame() const {
  switch (step_) {
    case SetupStep::place:
      return false;
    case SetupStep::calibrate:
      return !is_calibrated_ || wants_more_;
    case SetupStep::check:
      return results_.rig && !(check_ && check_->result());
    case SetupStep::coil:
      return true;
  }
  return true;
}

void SetupSteps::place(SetupView& now) {
  const auto placed = placement_.judge(*now.frame);
  now.sentence = placed.words();
  now.is_done = placed.isGood();
  for (const auto& finding : placed.findings) now.lines.push_back({finding.is_good, finding.words});
  now.left_box = placed.left_face;
  now.right_box = placed.right_face;
}

void SetupSteps::addView(SetupView& now) {
  const auto sight = is_new_ ? collector_.add(*now.frame) : BoardSight{};
  now.left_marks = sight.left.px;
  now.right_marks = sight.right.px;
  if (sight.state == BoardSight::State::taken)
    now.sentence = "view taken: " + collector_.wish();
  else
    now.sentence = sight.state == BoardSight::State::none ? collector_.wish() : sight.reason;
  // Shows the reason of a failed calibration until there is a new view.
  if (!calibration_words_.empty() && collector_.views().empty()) now.sentence = calibration_words_;
}

void SetupSteps::count(SetupView& now) const {
  now.views = int(collector_.views().size());
  now.coverage = collector_.coverage();
  now.progress = std::min(1.0, now.views / kUsualViews);
}

void SetupSteps::collect(SetupView& now, const Publish& publish) {
  if (!is_calibrated_ || wants_more_) {
    addView(now);
    if (is_finish_wanted_ || (collector_.isEnough() && !wants_more_)) calibrateNow(now, publish);
  }
  count(now);
  if (!is_calibrated_ || wants_more_) return;
  now.sentence = calibration_words_.empty() ? "these cameras are calibrated: go on" : calibration_words_;
  now.lines = calibration_lines_;
  now.is_done = true;
  now.progress = 1.0;
}

void SetupSteps::calibrateNow(SetupView& now, const Publish& publish) {
  is_finish_wanted_ = wants_more_ = false;
  SetupView waiting = now;
  count(waiting);
  waiting.sentence = "the calibration is calculated: some seconds";
  publish(waiting);
  TaskMonitor monitor;
  try {
    keep(collector_.calibrate(monitor));
    is_calibrated_ = true;
  } catch (const Error& error) {
    now.sentence = calibration_words_ = error.what();
    collector_.clear();  // adding views to those that do not fit would not help
    is_calibrated_ = false;
  }
}

void SetupSteps::describe(const cameras::Calibration& result) {
  const auto& effect = results_.uncertainty;
  const bool is_good = effect && effect->point_mm <= options_.good_mm;
  calibration_lines_ = {{true, formatted("%d views, %.2f px", result.usedViews(), result.rms_px)}};
  if (effect)
    calibration_lines_.push_back({is_good, formatted("a point at %.0f mm is measured to +-%.2f mm",
                                                     effect->distance_mm, effect->point_mm)});
  for (const auto& view : result.views)
    if (!view.is_used) calibration_lines_.push_back({false, view.name + " is not used: " + view.reason});
  for (const auto& warning : result.warnings) calibration_lines_.push_back({false, warning});
  if (!effect)
    calibration_words_ = "calibrated; its uncertainty is not known: take more views";
  else if (is_good)
    calibration_words_ = formatted("calibrated: +-%.2f mm at the target; go on", effect->point_mm);
  else
    calibration_words_ =
        formatted("calibrated, but only to +-%.2f mm: take more views, tilted and near", effect->point_mm);
}

void SetupSteps::keep(const cameras::Calibration& result) {
  results_ = {result.rig, uncertaintyAt(result.rig, options_.distance_mm), {}, {}, {}};
  describe(result);
  check_.reset();
  coil_.reset();
}

void SetupSteps::verify(SetupView& now) {
  if (!results_.rig) {
    now.sentence = kCalibrateFirst;
    return;
  }
  if (!check_)
    check_ = std::make_unique<RigCheckRun>(*results_.rig, options_.board, options_.coil,
                                           methods_.make_coil_tracker);
  if (!check_->result()) {
    const auto sight = is_new_ ? check_->add(*now.frame) : BoardSight{};
    now.left_marks = sight.left.px;
    now.right_marks = sight.right.px;
    const auto first = check_->firstPlace();
    now.sentence = checkWords(sight, first);
    if (first) now.lines = checkLines(*first);
  }
  now.progress = check_->progress();
  if (!check_->result()) return;
  const health::RigVerification& found = *check_->result();
  now.sentence = found.words();
  now.is_done = found.state == health::RigState::holds;
  now.needs_repair = !now.is_done && found.state != health::RigState::unclear;
  now.lines = checkLines(found);
  results_.verification = found;
}

void SetupSteps::followCoil(SetupView& now) {
  if (!results_.rig) {
    now.sentence = kCalibrateFirst;
    return;
  }
  if (!coil_) coil_ = std::make_unique<CoilSetup>(*results_.rig, options_.coil, methods_.make_coil_tracker);
  if (is_new_) coil_->add(*now.frame);
  now.sentence = coil_->words();
  now.left_marks = coil_->leftCorners();
  now.right_marks = coil_->rightCorners();
  now.progress = coil_->progress();
  now.is_done = coil_->stage() == CoilSetup::Stage::done ||
                (coil_->stage() == CoilSetup::Stage::look && coil_->isSeen() && !coil_->hasTrouble());
  now.lines.push_back({coil_->isSeen(), coil_->isSeen() ? "the coil's marker is seen" : "no marker is seen"});
  if (coil_->stage() == CoilSetup::Stage::jig)
    now.lines.push_back(
        {coil_->isJigSeen(), coil_->isJigSeen() ? "the jig's marker is seen" : "no jig is seen"});
  results_.coil = coil_->result();
  if (coil_->stage() != CoilSetup::Stage::wave) return;
  now.is_done = coil_->wave()->isDone();
  results_.row_times_s = coil_->wave()->rowTimes_s();
}

void SetupSteps::go(SetupStep step) {
  if (step_ != step && step == SetupStep::check) check_.reset();
  step_ = step;
}

void SetupSteps::useBoard(const cameras::Board& board) {
  options_.board = board;
  collector_ = BoardCollector(board, size_);
  check_.reset();
  if (!options_.rig) is_calibrated_ = false;
}

void SetupSteps::finishViews() { is_finish_wanted_ = int(collector_.views().size()) >= kFewestSetupViews; }

void SetupSteps::repeatViews() {
  collector_.clear();
  is_calibrated_ = wants_more_ = false;
  calibration_words_.clear();
  calibration_lines_.clear();
}

void SetupSteps::useCoil(const coil_tracking::CoilModel& coil) {
  options_.coil = coil;
  coil_.reset();
  check_.reset();
}

void SetupSteps::startPivots() {
  if (coil_) coil_->startPivots();
}

void SetupSteps::startJig(const coil_tracking::CoilModel& jig) {
  if (coil_) coil_->startJig(jig);
}

void SetupSteps::startWave() {
  results_.row_times_s.reset();
  if (coil_) coil_->startWave();
}

}  // namespace facenav::steps
