#include "presenters/treat_presenter.h"

#include <QFileInfo>
#include <QTime>
#include <future>

#include "facenav/core/error.h"
#include "facenav/core/log.h"
#include "facenav/workflow/session_report.h"
#include "facenav/workflow/software_version.h"

namespace facenav::ui {
namespace {

constexpr std::chrono::milliseconds kPatience(1000);  // for a session to end

/// Checks again right before use, because files may have changed on the disk since the case was opened.
void requireSignOff(const casefile::CaseStore& store, bool is_overridden) {
  if (is_overridden || casefile::signOffStatus(store).holds()) return;
  throw Error("the case is not signed off", signOffWords(casefile::signOffStatus(store)).toStdString(),
              "have it checked (Prepare, step 4)");
}

/// Key frames of the face from earlier sessions. Empty if a file is damaged: the session runs without them.
std::vector<casefile::StoredKeyFrame> storedKeyFrames(const std::filesystem::path& case_folder) {
  try {
    return casefile::readKeyFrames(case_folder);
  } catch (const Error& error) {
    logWarning(error.what());
    return {};
  }
}

void storeKeyFrames(const session::Session& session, const std::filesystem::path& case_folder) {
  try {
    casefile::addKeyFrames(case_folder, session.learntKeyFrames());
  } catch (const std::exception& error) {  // no caller to report to
    logWarning(std::string("the looks of the face were not kept: ") + error.what());
  }
}

void keepReport(const std::filesystem::path& case_folder, const std::filesystem::path& session_folder) {
  try {
    workflow::writeSessionReport(case_folder, session_folder);
  } catch (const std::exception& error) {  // no caller to report to; `facenav report` can make it again
    logWarning(std::string("the session's report was not written: ") + error.what());
  }
}

}  // namespace

TreatPresenter::TreatPresenter(const Services& services, CaseModel& model, TaskRunner& tasks, QObject* parent,
                               pictures::OverlayWorker::Draw draw)
    : QObject(parent),
      services_(services),
      model_(model),
      tasks_(tasks),
      cameras_(services, tasks),
      coil_(coil_tracking::defaultCoil()),
      overlays_(
          [this](std::shared_ptr<const pictures::DrawnOverlay> drawn) {
            QMetaObject::invokeMethod(
                this, [this, drawn] { emit overlayDrawn(drawn); }, Qt::QueuedConnection);
          },
          std::move(draw)) {
  connect(&model_, &CaseModel::opened, this, [this] {
    stop();
    outcome_.reset();
    const auto& targets = model_.current().plan.targets;
    target_ = targets.empty() ? QString() : QString::fromStdString(targets.front().name);
    emit changed();
  });
  connect(&cameras_, &CamerasPresenter::opened, this, &TreatPresenter::useCameras);
  connect(&cameras_, &CamerasPresenter::captureTaken, this, [this] {
    recording_->capture = cameras_.capture();
    outcome_.reset();
    emit changed();
  });
  connect(&cameras_, &CamerasPresenter::refused, this, &TreatPresenter::refused);
  connect(&model_, &CaseModel::planChanged, this, [this] {
    if (!target())
      target_ = model_.current().plan.targets.empty()
                    ? QString()
                    : QString::fromStdString(model_.current().plan.targets.front().name);
    chooseTarget(target_);
  });
}

TreatPresenter::~TreatPresenter() {
  if (session_) endSession();
}

void TreatPresenter::openRecording(const QString& folder) {
  tasks_.start(tr("Opening the recording"), [this, folder](TaskMonitor&) -> TaskRunner::Delivery {
    const std::filesystem::path path(folder.toStdString());
    auto recording = std::make_shared<capture::Recording>(capture::openRecording(path));
    const auto coil_file = path / "coil.json";
    auto coil = std::make_shared<coil_tracking::CoilModel>(std::filesystem::exists(coil_file)
                                                               ? coil_tracking::readCoil(coil_file)
                                                               : coil_tracking::defaultCoil());
    return [this, recording, coil] {
      stop();
      recording_ = *recording;
      is_live_ = false;
      rig_fault_.clear();
      coil_ = *coil;
      outcome_.reset();
      emit changed();
      cameras_.show(*recording);  // last, because it throws if the folder has vanished meanwhile
    };
  });
}

/// The old alignment is no longer valid.
void TreatPresenter::useCameras() {
  stop();
  recording_ = capture::Recording{};
  recording_->rig = *cameras_.rig();
  is_live_ = true;
  outcome_.reset();
  rig_fault_.clear();
  emit changed();
}

bool TreatPresenter::canAlign() const {
  return recording_ && mayTreat() && !isRunning() && (!is_live_ || recording_->capture);
}

void TreatPresenter::align(bool then_start) {
  if (!canAlign()) {  // live cameras need current images, never an old capture
    if (is_live_ && mayTreat()) emit refused(tr("take the two pictures first (step 1)"));
    return;
  }
  tasks_.start(
      tr("Aligning the head"),
      [this, then_start, store = model_.current().store, is_overridden = model_.override().has_value(),
       recording = *recording_](TaskMonitor& monitor) -> TaskRunner::Delivery {
        requireSignOff(store, is_overridden);
        auto outcome =
            std::make_shared<workflow::AlignmentOutcome>(services_.align(store, recording, monitor));
        return [this, outcome, then_start] {
          outcome_ = outcome;
          emit changed();
          if (then_start) start();
        };
      });
}

void TreatPresenter::start() {
  if (!recording_ || !outcome_ || isRunning() || tasks_.isRunning() || !mayTreat()) return;
  session::NavigatorSetup setup;
  setup.rig = recording_->rig;
  setup.reference = outcome_->reference;
  setup.camera_T_mri_at_reference = outcome_->result.camera_T_mri;
  setup.coil = coil_;
  setup.scalp = outcome_->scalp;
  setup.pace = head_tracking::Pace::live;
  tasks_.start(
      tr("Starting the trackers"),
      [this, setup, recording = *recording_, is_live = is_live_, left = cameras_.left(),
       right = cameras_.right(), seen = cameras_.release(), store = model_.current().store,
       is_overridden = model_.override().has_value()](TaskMonitor&) mutable -> TaskRunner::Delivery {
        requireSignOff(store, is_overridden);
        seen.reset();  // first: a camera can be opened only once
        setup.key_frames = storedKeyFrames(store.folder());
        std::shared_ptr<session::Navigator> navigator = services_.makeNavigator(setup);
        auto source = std::make_shared<std::unique_ptr<capture::FrameSource>>(
            is_live ? services_.openCameras(setup.rig, left, right) : capture::makeSource(recording));
        return [this, navigator, source] { startNavigator(navigator, std::move(*source)); };
      });
}

/// A session that ended by itself still exists, with its log. It is ended first.
void TreatPresenter::startNavigator(std::shared_ptr<session::Navigator> navigator,
                                    std::unique_ptr<capture::FrameSource> source) {
  if (session_) endSession();
  navigator->setTarget(chosen());
  session::SessionOptions options;
  options.is_paced = !is_live_;
  auto session = std::make_shared<session::Session>(
      std::move(source), std::make_unique<session::Navigator>(std::move(*navigator)), options);
  const auto folder = model_.current().store.folder();
  log_ = std::make_unique<session::TreatmentLog>(session, folder);  // if this throws, nothing has started
  session_ = std::move(session);
  treated_ = folder;
  if (const auto& given = model_.override())
    log_->addEvent("override", (given->by + ": " + given->reason).toStdString());
  log_->addEvent("target", target_.toStdString());
  log_->addEvent("coil", coil_.name);
  log_->addEvent("alignment", alignmentWords().toStdString());
  session_->start();
  emit changed();
}

void TreatPresenter::overrideSignOff(const QString& by, const QString& reason) {
  if (!model_.isOpen()) return;
  try {
    casefile::recordOverride(model_.current().store, by.trimmed().toStdString(),
                             reason.trimmed().toStdString(), workflow::softwareVersion());
    model_.setOverride({by.trimmed(), reason.trimmed()});
    emit changed();
  } catch (const Error& error) {
    emit refused(QString::fromUtf8(error.what()));
  }
}

void TreatPresenter::countPulse() {
  if (log_ && isRunning()) log_->addPulse();
}

QString TreatPresenter::sessionTime() const {
  if (!session_) return {};
  return QTime(0, 0).addMSecs(int(1e3 * session_->elapsed_s())).toString("hh:mm:ss");
}

QString TreatPresenter::logFailure() const {
  return log_ ? QString::fromStdString(log_->failure()) : QString();
}

void TreatPresenter::stop() {
  if (session_) endSession();
  emit changed();
}

/// Nothing of the session is shown from here on. A good camera ends within one frame, the log when all is
/// written; the report follows without the window waiting for it.
void TreatPresenter::endSession() {
  auto has_ended = std::make_shared<std::promise<void>>();
  retirement_.add(
      [folder = treated_, session_folder = log_->folder(), ended = has_ended->get_future().share()] {
        ended.wait();
        keepReport(folder, session_folder);
      },
      std::chrono::milliseconds(0));
  retirement_.add(
      [session = std::move(session_), log = std::shared_ptr(std::move(log_)), folder = treated_,
       has_ended]() mutable {
        session->stop();
        storeKeyFrames(*session, folder);
        log.reset();
        session.reset();
        has_ended->set_value();
      },
      kPatience);
}

void TreatPresenter::chooseTarget(const QString& name) {
  target_ = name;
  if (session_) session_->setTarget(chosen());
  if (log_) log_->addEvent("target", name.toStdString());
  emit changed();
}

const guidance::Target* TreatPresenter::target() const {
  if (!model_.isOpen()) return nullptr;
  for (const auto& t : model_.current().plan.targets)
    if (t.name == target_.toStdString()) return &t;
  return nullptr;
}

std::optional<session::ChosenTarget> TreatPresenter::chosen() const {
  const auto* t = target();
  if (!t) return std::nullopt;
  return session::ChosenTarget{*t, outcome_ ? outcome_->result.predictedError_mm(t->cortex_point) : 0.0};
}

QString TreatPresenter::recordingFolder() const {
  return recording_ && !is_live_ ? QString::fromStdString(recording_->folder.string()) : QString();
}

QString TreatPresenter::recordingWords() const {
  if (!recording_) return tr("no cameras");
  if (is_live_) return tr("cameras %1 and %2, live").arg(cameras_.left()).arg(cameras_.right());
  return tr("%1: %2 frames, %3 per s%4")
      .arg(QString::fromStdString(recording_->folder.filename().string()))
      .arg(qlonglong(recording_->frame_count))
      .arg(recording_->frames_per_s, 0, 'f', 0)
      .arg(recording_->has_timestamps ? QString() : tr(" (assumed)"));
}

QString TreatPresenter::alignmentWords() const {
  if (!outcome_) return tr("not aligned in this session");
  QString words = tr("aligned: %1 mm rms over %2 points")
                      .arg(outcome_->result.rms_mm, 0, 'f', 2)
                      .arg(outcome_->result.points);
  if (const auto* t = target())
    words += tr(", \u00b1%1 mm at %2")
                 .arg(outcome_->result.predictedError_mm(t->cortex_point), 0, 'f', 1)
                 .arg(target_);
  return words;
}

std::shared_ptr<const session::NavigationState> TreatPresenter::state() const {
  if (session_) {
    const auto latest = session_->latest();
    if (!latest->rig_fault.empty()) rig_fault_ = QString::fromStdString(latest->rig_fault);
    if (!session_->hasEnded() || !latest->failure.empty()) return latest;
    return std::make_shared<session::NavigationState>(session::blanked(*latest, LostReason::stale));
  }
  return std::make_shared<session::NavigationState>(session::blanked({}, LostReason::stale));
}

void TreatPresenter::askOverlay(std::shared_ptr<const session::NavigationState> state) {
  if (!recording_ || !state->images) return;
  const auto* t = target();
  overlays_.ask({recording_->rig, std::move(state), t ? std::optional<guidance::Target>(*t) : std::nullopt});
}

}  // namespace facenav::ui
