#include "home/home_presenter.h"

#include <QSettings>
#include <utility>

#include "facenav/coil_library/coil_library.h"
#include "facenav/core/error.h"
#include "shell/shown_words.h"
#include "treat/session_end.h"

namespace facenav::ui {
namespace {

constexpr double kQuestion_s = 12.0;  // the question to finish stands this long

}  // namespace

HomePresenter::HomePresenter(const Services& services, TaskRunner& tasks, QObject* parent)
    : QObject(parent), services_(services), tasks_(tasks), cameras_(services, tasks) {
  connect(&tasks_, &TaskRunner::failed, this,
          [this](const QString& words) { refuse(words, tasks_.failure()); });
  connect(&cameras_, &CamerasPresenter::changed, this, &HomePresenter::changed);
  connect(&cameras_, &CamerasPresenter::refused, this,
          [this](const QString& words) { refuse(words, words.toStdString()); });
  cameras_.useCoilOf([this] { return home_ ? home_->coil : coil_tracking::defaultCoil(); });
  // Queued, so that it runs after the task that took the runner.
  connect(
      &cameras_, &CamerasPresenter::captureTaken, this,
      [this] {
        if (cameras_.capture()) align();
      },
      Qt::QueuedConnection);
}

HomePresenter::~HomePresenter() {
  if (treatment_) endBeside(retirement_, std::move(treatment_));
}

void HomePresenter::set(Stage stage, const QString& refusal) {
  stage_ = stage;
  refusal_ = refusal;
  emit changed();
}

/// Shows the refusal and returns to the stage from which the user can continue.
void HomePresenter::refuse(const QString& words, const std::string& failure) {
  const QString sentence = shownWords(steps::homeRefusal(Error(failure)));
  if (!home_) return set(Stage::unusable, words);
  if (stage_ == Stage::ending) return set(Stage::ended, words);
  set(Stage::sit, sentence);
}

void HomePresenter::open(const QString& case_folder) {
  tasks_.start(tr("Opening"), [this, case_folder](TaskMonitor&) -> TaskRunner::Delivery {
    auto home = std::make_shared<steps::HomeCase>(
        steps::openHomeCase(std::filesystem::path(case_folder.toStdString())));
    return [this, home] {
      home_ = *home;
      play_refusal_.isEmpty() ? set(Stage::sit) : set(Stage::unusable, play_refusal_);
    };
  });
}

/// Uses only the recording's pictures; the coil is the case's.
void HomePresenter::play(const QString& recording) {
  try {
    recording_ = capture::openRecording(std::filesystem::path(recording.toStdString()));
    if (!recording_->capture)
      throw Error("the recording has no pictures to know the face by", recording.toStdString());
    emit changed();
  } catch (const Error& error) {
    recording_.reset();
    play_refusal_ = shownWords(error);
    set(Stage::unusable, play_refusal_);
  }
}

QString HomePresenter::actionWords() const {
  if (tasks_.isRunning()) return {};
  switch (stage_) {
    case Stage::sit:
      if (recording_) return refusal_.isEmpty() ? tr("START") : tr("TRY AGAIN");
      if (!cameras_.isLive()) return tr("OPEN THE CAMERAS");
      return refusal_.isEmpty() ? tr("TAKE THE PICTURE") : tr("TRY AGAIN");
    case Stage::guiding:
      return asksToFinish() ? tr("YES, FINISH") : tr("FINISH");
    case Stage::ended:
      return saved_as_.isEmpty() ? tr("SAVE THE FILE TO SEND") : tr("CLOSE");
    default:
      return {};
  }
}

QString HomePresenter::words() const {
  if (!refusal_.isEmpty()) return refusal_;
  switch (stage_) {
    case Stage::opening:
      return tr("One moment.");
    case Stage::unusable:
      return tr("This case cannot be used here: call the clinic.");
    case Stage::sit:
      if (recording_) return tr("Sit still, look at the cameras, and press START.");
      if (!cameras_.isLive()) return cameras_.words();
      return tasks_.isRunning()
                 ? tr("Look at the cameras, and hold the coil still beside the face, its marker to them.")
                 : tr("Press the button, look at the cameras, and hold the coil still beside the face.");
    case Stage::starting:
      return tr("Sit still: your face is being measured.");
    case Stage::ending:
      return tr("The session is being closed.");
    case Stage::ended:
      if (!saved_as_.isEmpty()) return tr("Saved: send this file to the clinic.");
      return counts_.on_target > 0
                 ? tr("Finished: save the file, and send it to the clinic.")
                 : tr("Finished without a pulse on target: save the file, and call the clinic.");
    case Stage::guiding:
      return asksToFinish() ? tr("Finish now? Press the button again. To go on, wait or press Esc.")
                            : QString();
  }
  return {};
}

bool HomePresenter::asksToFinish() const {
  return stage_ == Stage::guiding && asked_to_finish_ && Timestamp::now() - *asked_to_finish_ < kQuestion_s;
}

void HomePresenter::goOn() {
  asked_to_finish_.reset();
  emit changed();
}

void HomePresenter::act() {
  if (tasks_.isRunning()) return;
  if (stage_ == Stage::guiding) {
    if (asksToFinish()) return finish();
    asked_to_finish_ = Timestamp::now();
    return void(emit changed());
  }
  if (stage_ == Stage::ended) return saved_as_.isEmpty() ? emit saveWanted() : void();
  if (stage_ != Stage::sit || !home_) return;
  if (recording_) return align();
  if (!cameras_.isLive()) return cameras_.open();
  refusal_.clear();
  cameras_.takeMarked();
}

void HomePresenter::align() {
  capture::Recording seen;
  if (recording_) {
    seen = *recording_;
  } else {
    seen.rig = *cameras_.rig();
    seen.capture = cameras_.capture();
  }
  set(Stage::starting);
  tasks_.start(
      tr("Measuring the face"),
      [this, store = home_->store, seen, coil = home_->coil](TaskMonitor& monitor) -> TaskRunner::Delivery {
        auto outcome =
            std::make_shared<steps::AlignmentOutcome>(services_.align(store, seen, {&coil, false}, monitor));
        return [this, outcome] { startTrackers(outcome); };
      });
}

void HomePresenter::startTrackers(std::shared_ptr<const steps::AlignmentOutcome> outcome) {
  capture::Recording seen;
  if (recording_)
    seen = *recording_;
  else
    seen.rig = *cameras_.rig();
  steps::TreatmentRequest request{home_->store,
                                  seen,
                                  !recording_.has_value(),
                                  home_->coil,
                                  std::move(outcome),
                                  coil_library::calibrationReminder(home_->card)};
  if (!recording_) request.keepLearnt = cameras_.keeper();
  request.focus_caution = coil_library::focusCaution(home_->card);
  steps::CameraTurnover cameras{recording_ ? nullptr : cameras_.opener(), cameras_.release()};
  tasks_.start(tr("Starting"), [this, request, cameras](TaskMonitor&) mutable -> TaskRunner::Delivery {
    const auto prepared = steps::prepareTreatment(request, services_.makeNavigator, cameras);
    return [this, prepared] { begin(*prepared); };
  });
}

void HomePresenter::begin(steps::PreparedTreatment& prepared) {
  const auto target = steps::chosenTarget(home_->target, prepared.request.alignment.get());
  treatment_ = std::make_shared<steps::Treatment>(std::move(prepared), target);
  treatment_->log().addEvent("at home", "three steps, big buttons");
  session_ = treatment_->log().folder();
  planned_ = treatment_->plannedPulses();
  other_coil_.emplace(home_->coil);
  saved_as_.clear();
  const auto source = QSettings().value("treat/pulses").toString().toStdString();
  if (!source.empty()) treatment_->tryToListen(source);
  set(Stage::guiding);
}

std::shared_ptr<const session::NavigationState> HomePresenter::state() const {
  if (treatment_) return treatment_->session().latest();
  return std::make_shared<session::NavigationState>(session::blanked({}, LostReason::stale));
}

std::shared_ptr<const cameras::StereoFrame> HomePresenter::stillPicture() const {
  const bool is_waiting = stage_ == Stage::sit || stage_ == Stage::starting;
  const auto& capture = recording_ ? recording_->capture : cameras_.capture();
  if (!is_waiting || !capture) return nullptr;
  return std::make_shared<const cameras::StereoFrame>(capture->plain);
}

steps::HomeAdvice HomePresenter::advice() {
  if (!treatment_) return {};
  const auto now = state();
  if (treatment_->session().hasEnded() && now->failure.empty())
    return {steps::HomeStep::sit, steps::HomeSign::none, 0, "The recording is over: press FINISH.", false};
  return steps::homeAdvice(*now, other_coil_->sees(*now));
}

void HomePresenter::countPulse(Timestamp at) {
  if (treatment_ && stage_ == Stage::guiding) treatment_->pressPulse(at);
}

session::PulseCounts HomePresenter::pulseCounts() const {
  return treatment_ ? treatment_->log().counts() : counts_;
}

std::optional<int> HomePresenter::plannedPulses() const { return planned_; }

QString HomePresenter::reminder() const {
  if (!home_) return {};
  if (!coil_library::calibrationReminder(home_->card)) return {};
  return tr("The coil's calibration is old or not recorded: tell the clinic.");
}

/// Ends the session on another thread; the window no longer shows it.
void HomePresenter::finish() {
  asked_to_finish_.reset();
  counts_ = treatment_->log().counts();
  tasks_.start(tr("Closing"),
               [this, treatment = std::exchange(treatment_, nullptr)](TaskMonitor&) -> TaskRunner::Delivery {
                 treatment->end();
                 report::ReportOptions options;
                 options.language = reportLanguage();
                 treatment->keepReport(options);
                 return [this] { set(Stage::ended); };
               });
  set(Stage::ending);
}

QString HomePresenter::sendBackName() const {
  return QString("facenav_%1.zip").arg(QString::fromStdString(session_.filename().string()));
}

bool HomePresenter::save(const QString& file) {
  if (stage_ != Stage::ended || file.isEmpty()) return false;
  try {
    steps::writeSendBack(home_->store, session_, std::filesystem::path(file.toStdString()));
    saved_as_ = file;
    set(Stage::ended);
    return true;
  } catch (const Error& error) {
    set(Stage::ended, shownWords(error));
    return false;
  }
}

QStringList HomePresenter::saveIn(const QStringList& folders) {
  QStringList saved;
  QString refusal;
  for (const QString& folder : folders) {
    if (save(folder + "/" + sendBackName()))
      saved << folder;
    else
      refusal = refusal_;
  }
  if (saved.isEmpty()) return set(Stage::ended, refusal), saved;
  saved_as_ = saved.front() + "/" + sendBackName();
  set(Stage::ended);
  return saved;
}

}  // namespace facenav::ui
