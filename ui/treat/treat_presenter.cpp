#include "treat/treat_presenter.h"

#include <QSettings>

#include "facenav/core/error.h"
#include "facenav/core/software_version.h"
#include "facenav/prepare/sign_off_gate.h"
#include "facenav/treat/served_tracker.h"
#include "facenav/treat/session_return.h"
#include "facenav/treat/tracker_alignment.h"
#include "plan/field_presenter.h"
#include "shell/shown_words.h"
#include "treat/recording_words.h"

namespace facenav::ui {
TreatPresenter::TreatPresenter(const Services& services, CaseModel& model, TaskRunner& tasks, QObject* parent,
                               pictures::OverlayWorker::Draw draw)
    : QObject(parent),
      services_(services),
      model_(model),
      tasks_(tasks),
      cameras_(services, tasks),
      tracker_(model),
      offers_(model),
      pulse_source_(QSettings().value(kPulseSource).toString()),
      overlays_(
          [this](std::shared_ptr<const pictures::DrawnOverlay> drawn) {
            QMetaObject::invokeMethod(
                this, [this, drawn] { emit overlayDrawn(drawn); }, Qt::QueuedConnection);
          },
          std::move(draw)) {
  connect(&model_, &CaseModel::opened, this, &TreatPresenter::forgetCase);
  const auto forget_doing = [this] {
    if (tasks_.isRunning() || doing_.isEmpty()) return;  // a task may have started the next one
    doing_.clear();
    emit changed();
  };
  for (const auto over : {&TaskRunner::succeeded, &TaskRunner::cancelled})
    connect(&tasks_, over, this, forget_doing);
  connect(&tasks_, &TaskRunner::failed, this, forget_doing);
  cameras_.useCoilOf([this] { return coil_.model(); });
  connect(&cameras_, &CamerasPresenter::opened, this, &TreatPresenter::useCameras);
  connect(&cameras_, &CamerasPresenter::closed, this, &TreatPresenter::forgetCameras);
  connect(&cameras_, &CamerasPresenter::captureTaken, this, [this] {
    recording_->capture = cameras_.capture();
    aligned_ = {};
    emit changed();
  });
  connect(&cameras_, &CamerasPresenter::refused, this, &TreatPresenter::refused);
  connect(&tracker_, &TrackerPresenter::opened, this, &TreatPresenter::useTracker);
  connect(&tracker_, &TrackerPresenter::closed, this, [this] {
    if (!is_live_ && !isRunning()) recording_.reset();
  });
  connect(&tracker_, &TrackerPresenter::alignmentChanged, this, [this] {
    if (hasTracker() && !isRunning()) aligned_ = {};
  });
  connect(&tracker_, &TrackerPresenter::changed, this, &TreatPresenter::changed);
  connect(&tracker_, &TrackerPresenter::refused, this, &TreatPresenter::refused);
  connect(&offers_, &OffersPresenter::refused, this, &TreatPresenter::refused);
  connect(&offers_, &OffersPresenter::decided, this, [this](const QString& event, const QString& words) {
    if (treatment_) treatment_->log().addEvent(event.toStdString(), words.toStdString());
  });
  connect(&model_, &CaseModel::planChanged, this, [this] {
    if (offers_.isTaking()) return void(emit changed());  // what another program sent is never aimed at
    if (!target())
      target_ = model_.current().plan.targets.empty()
                    ? QString()
                    : QString::fromStdString(model_.current().plan.targets.front().name);
    chooseTarget(target_);
  });
}

TreatPresenter::~TreatPresenter() {
  if (treatment_) endSession("the window was closed");
}

/// Discards pictures and alignment: another case may be another patient.
void TreatPresenter::forgetCase() {
  stop("another case was opened");
  outputs_->setCase(model_.current().store.folder());
  offers_.forget();
  second_.chooseTarget({});
  aligned_ = {};
  if (is_live_) recording_->capture.reset();
  cameras_.forgetPictures();
  site_.reset();
  last_session_.clear();
  const auto& targets = model_.current().plan.targets;
  target_ = targets.empty() ? QString() : QString::fromStdString(targets.front().name);
  emit changed();
}

void TreatPresenter::openRecording(const QString& folder) {
  startTask(
      tr("Opening the recording"), tr("OPENING THE RECORDING"),
      [this, folder](TaskMonitor&) -> TaskRunner::Delivery {
        auto film = std::make_shared<steps::TreatmentFilm>(
            steps::openTreatmentFilm(std::filesystem::path(folder.toStdString())));
        return [this, film] {
          stop("another recording was opened");
          tracker_.close();
          recording_ = film->recording;
          is_live_ = false;
          rig_fault_.clear();
          coil_.useFilm(*film);
          aligned_ = {};
          emit changed();
          cameras_.show(film->recording);  // last, because it throws if the folder has vanished meanwhile
        };
      });
}

void TreatPresenter::startTask(const QString& title, const QString& doing, TaskRunner::Work work) {
  if (!tasks_.start(title, std::move(work))) return;
  doing_ = doing;
  emit changed();
}

/// Uses another tracker's head and coil; the old alignment is no longer valid.
void TreatPresenter::useTracker() {
  stop("another tracker is used");
  if (cameras_.hasPictures()) cameras_.closeCameras();
  recording_ = capture::Recording{};
  recording_->rig = steps::makeFramesWithoutPictures()->rig();
  is_live_ = false;
  coil_.useRemembered();
  aligned_ = {};
  rig_fault_.clear();
  emit changed();
}

/// Uses the cameras; the old alignment is no longer valid.
void TreatPresenter::useCameras() {
  stop("the cameras were opened again");
  tracker_.close();
  recording_ = capture::Recording{};
  recording_->rig = cameras_.lastOpened()->rig;
  is_live_ = true;
  coil_.useRemembered();
  aligned_ = {};
  rig_fault_.clear();
  emit changed();
}

/// Discards what was measured with the cameras, which may be moved or calibrated anew now.
void TreatPresenter::forgetCameras() {
  if (!is_live_ || isRunning()) return;
  recording_.reset();
  is_live_ = false;
  aligned_ = {};
  emit changed();
}

void TreatPresenter::chooseCoil(const QString& name) {
  try {
    coil_.choose(name, [this](const coil_tracking::CoilModel& coil) {
      if (isRunning()) treatment_->chooseCoil(coil);
    });
  } catch (const Error& error) {
    emit refused(shownWords(error));
  }
  emit changed();
}

bool TreatPresenter::canAlign() const {
  if (hasTracker() && !tracker_.hasAlignment()) return false;
  return recording_ && mayTreat() && !isRunning() && (!is_live_ || recording_->capture) &&
         withheldWords().isEmpty() && otherChoiceWords().isEmpty();
}

bool TreatPresenter::refuseCameras() {
  const QString fault = withheldWords().isEmpty() ? otherChoiceWords() : withheldWords();
  if (!fault.isEmpty()) emit refused(fault);
  return !fault.isEmpty();
}

void TreatPresenter::align(bool then_start, bool is_patient_confirmed) {
  if (!canAlign()) {  // live cameras need current images, never an old capture
    if (refuseCameras()) return;
    if (is_live_ && mayTreat()) emit refused(tr("take the picture first (step 1)"));
    return;
  }
  if (hasTracker()) return alignByFile();
  startTask(
      tr("Aligning the head"), tr("ALIGNING: the face is measured and fitted to the scan"),
      [this, then_start, is_patient_confirmed, store = model_.current().store,
       is_overridden = model_.override().has_value(), recording = *recording_,
       coil = coil_.model()](TaskMonitor& monitor) -> TaskRunner::Delivery {
        steps::requireSignOff(store, is_overridden);
        const auto aligned = alignHead(services_, store, recording, {&coil, is_patient_confirmed}, monitor);
        return [this, aligned, then_start] {
          if (aligned.person_unclear) {
            emit changed();
            return void(emit personUnclear(shownWords(*aligned.person_unclear), then_start));
          }
          use(aligned);
          emit changed();
          if (then_start) start();
        };
      });
}

/// Takes the alignment of the tool on the head from its file.
void TreatPresenter::alignByFile() {
  startTask(tr("Aligning the head"), tr("ALIGNING: the tracker's alignment is read"),
            [this, store = model_.current().store, is_overridden = model_.override().has_value(),
             file = tracker_.tracker().alignment](TaskMonitor&) -> TaskRunner::Delivery {
              steps::requireSignOff(store, is_overridden);
              AlignedHead aligned;
              aligned.outcome = std::make_shared<const steps::AlignmentOutcome>(
                  steps::outcomeOf(steps::readTrackerAlignment(file), store));
              return [this, aligned] {
                use(aligned);
                for (const auto& caution : aligned.outcome->result.cautions)
                  emit refused(shownWords(caution));
                emit changed();
              };
            });
}

void TreatPresenter::use(const AlignedHead& aligned) {
  aligned_ = aligned;
  is_judged_wrong_ = false;
  shows_skin_ = true;
}

void TreatPresenter::start() {
  if (!recording_ || !isAligned() || isRunning() || tasks_.isRunning() || !mayTreat()) return;
  startWith({});
}

/// Continues the session with the face as it was at that session's alignment, not as it is now.
void TreatPresenter::goOn(const casefile::SessionSoFar& session) {
  if (!canGoOn()) {
    refuseCameras();
    return;
  }
  auto recording = *recording_;
  recording.capture.reset();
  startTask(tr("Going on with the session"), tr("ALIGNING: the face is fitted as in that session"),
            [this, session, recording, store = model_.current().store, coil = coil_.model(),
             is_overridden = model_.override().has_value()](TaskMonitor& monitor) -> TaskRunner::Delivery {
              steps::requireSignOff(store, is_overridden);
              const auto folder = steps::sessionToGoOnWith(store.folder(), session.name).folder;
              const auto aligned = alignHead(services_, store, recording, {&coil, false}, monitor);
              if (aligned.person_unclear) throw *aligned.person_unclear;
              return [this, aligned, folder, target = QString::fromStdString(session.target)] {
                use(aligned);
                chooseTarget(target);
                if (!target.isEmpty() && !this->target())
                  emit refused(tr("%1 is no longer in the plan: choose a target").arg(target));
                startWith(folder);
              };
            });
}

void TreatPresenter::startWith(const std::filesystem::path& goes_on) {
  if (is_live_) cameras_.readAgain();  // so that a note that they have moved takes effect at once
  if (!recording_ || refuseCameras()) return;
  steps::TreatmentRequest request{model_.current().store, *recording_, is_live_, coil_.model(),
                                  aligned_.outcome};
  coil_.noteIn(request);
  try {
    second_.addTo(request);
  } catch (const Error& error) {
    emit refused(shownWords(error));
    return;
  }
  request.goes_on = goes_on;
  request.field_coil = rememberedFieldCoil().toStdString();
  if (is_live_) request.keepLearnt = cameras_.keeper();
  if (const auto& given = model_.override())
    request.override = {given->by.toStdString(), given->reason.toStdString()};
  if (hasTracker()) {
    if (request.second.has_value() != !tracker_.tracker().second_coil.empty())
      return void(
          emit refused(tr("a second coil needs its name at the tracker (step 1), and that name a coil")));
    request.has_cameras = false;
    request.is_coil_served = true;
  }
  steps::CameraTurnover cameras{is_live_ ? cameras_.opener() : nullptr, cameras_.release()};
  startTask(
      tr("Starting the trackers"), tr("STARTING: the trackers get ready"),
      [this, request, cameras, tracker = hasTracker() ? std::optional(tracker_.tracker()) : std::nullopt](
          TaskMonitor&) mutable -> TaskRunner::Delivery {
        const auto prepared = tracker ? std::make_shared<steps::PreparedTreatment>(
                                            steps::prepareTreatment(request, steps::devicesOf(*tracker)))
                                      : steps::prepareTreatment(request, services_.makeNavigator, cameras);
        return [this, prepared] { begin(*prepared); };
      });
}

/// Begins a session. One that ended by itself still exists with its log, so it is ended first.
void TreatPresenter::begin(steps::PreparedTreatment& prepared) {
  if (treatment_) endSession("another session was started");
  treatment_ = std::make_shared<steps::Treatment>(std::move(prepared), chosen());
  last_session_ = treatment_->log().folder();
  treatment_->setIntensity(intensity_pct_);
  treatment_->sendTo(outputs_);
  emit changed();
  listen();
}

void TreatPresenter::showSkin(bool is_shown) {
  shows_skin_ = is_shown;
  emit changed();
}

void TreatPresenter::guideTo(const std::optional<guidance::Target>& site) {
  site_ = site;
  if (treatment_) treatment_->chooseTarget(chosen(), site ? site->name : target_.toStdString());
  emit changed();
}

void TreatPresenter::overrideSignOff(const QString& by, const QString& reason) {
  if (!model_.isOpen()) return;
  try {
    casefile::recordOverride(model_.current().store, by.trimmed().toStdString(),
                             reason.trimmed().toStdString(), softwareVersion());
    model_.setOverride({by.trimmed(), reason.trimmed()});
    emit changed();
  } catch (const Error& error) {
    emit refused(shownWords(error));
  }
}

void TreatPresenter::chooseTarget(const QString& name) {
  target_ = name;
  site_.reset();
  if (treatment_) treatment_->chooseTarget(chosen(), name.toStdString());
  emit changed();
}

const guidance::Target* TreatPresenter::target() const {
  if (!model_.isOpen()) return nullptr;
  if (site_) return &*site_;
  for (const auto& t : model_.current().plan.targets)
    if (t.name == target_.toStdString()) return &t;
  return nullptr;
}

std::optional<session::ChosenTarget> TreatPresenter::chosen() const {
  const auto* t = target();
  return t ? std::optional(steps::chosenTarget(*t, aligned_.outcome.get())) : std::nullopt;
}

QString TreatPresenter::recordingFolder() const {
  return recording_ && !is_live_ ? QString::fromStdString(recording_->folder.string()) : QString();
}

QString TreatPresenter::recordingWords() const {
  if (!recording_) return tr("no cameras");
  if (hasTracker()) return tracker_.nameWords();
  if (is_live_)
    return tr("cameras %1 and %2, live").arg(cameras_.lastOpened()->left, cameras_.lastOpened()->right);
  return wordsOf(*recording_);
}

QString TreatPresenter::alignmentWords() const {
  if (!isAligned()) return tr("not aligned in this session");
  return shownWords(steps::alignmentWords(*aligned_.outcome, target()));
}

std::shared_ptr<const session::NavigationState> TreatPresenter::state() const {
  if (treatment_) {
    const auto latest = treatment_->session().latest();
    if (latest->rig_correction) rig_fault_ = shownWords(inWords(*latest->rig_correction));
    if (const auto fault = session::rigFault(*latest)) rig_fault_ = shownWords(fault->words());
    if (!treatment_->session().hasEnded() || !latest->failure.empty()) return latest;
    return std::make_shared<session::NavigationState>(session::blanked(*latest, LostReason::stale));
  }
  return std::make_shared<session::NavigationState>(session::blanked({}, LostReason::stale));
}

void TreatPresenter::askOverlay(std::shared_ptr<const session::NavigationState> state) {
  if (!recording_ || !state->images || hasTracker()) return;
  const auto* t = target();
  pictures::OverlayOrder order{recording_->rig, std::move(state),
                               t ? std::optional<guidance::Target>(*t) : std::nullopt};
  if (shows_skin_ && aligned_.seen.skin) order.alignment = {aligned_.seen.skin, coil_.model().tip, spot_};
  overlays_.ask(std::move(order));
}

}  // namespace facenav::ui
