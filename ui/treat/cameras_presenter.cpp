#include "treat/cameras_presenter.h"

#include "facenav/align/automatic_capture.h"
#include "facenav/core/error.h"
#include "shell/shown_words.h"
#include "treat/preview_frames.h"

namespace facenav::ui {
namespace {

constexpr double kFresh_s = 0.5;  // an older image counts as outdated
constexpr double kMarkedWithin_s = 60.0;

}  // namespace

CamerasPresenter::CamerasPresenter(const Services& services, TaskRunner& tasks, QObject* parent)
    : QObject(parent), services_(services), tasks_(tasks), chosen_(services, tasks) {
  connect(&chosen_, &ChosenCameras::changed, this, &CamerasPresenter::changed);
  connect(&chosen_, &ChosenCameras::refused, this, &CamerasPresenter::refused);
}

void CamerasPresenter::lookEverywhere() { isLive() ? chosen_.refreshDevices() : chosen_.lookEverywhere(); }

/// Makes the verification; the window's own thread reads its result.
RigVerifying CamerasPresenter::verifying() const {
  RigVerifying verifying;
  if (coil_) verifying.coil = coil_();
  verifying.told = [start = start_](const steps::RigStart& found) {
    start->publish(std::make_shared<const steps::RigStart>(found));
  };
  return verifying;
}

QString CamerasPresenter::rigFault() const {
  if (const auto frame = picture(); frame && is_live_ && !frame->rig_fault.empty())
    return shownWords(frame->rig_fault);
  const auto found = start_->latest();
  return found && found->isWithheld() ? shownWords(found->words()) : QString();
}

QString CamerasPresenter::startWords() const {
  if (!chosen_.named()) return {};
  const auto found = start_->latest();
  return found ? shownWords(found->words())
               : tr("the cameras are compared with what was kept: look at them, and hold the coil still");
}

std::function<std::unique_ptr<capture::FrameSource>()> CamerasPresenter::opener() const {
  if (const auto named = chosen_.named(); named && services_.openRig)
    return [open = services_.openRig, rig = *named, verifying = verifying()] { return open(rig, verifying); };
  FACENAV_EXPECT(rig(), "a calibration is chosen first");
  return [open = services_.openCameras, rig = *rig(), left = left().toStdString(),
          right = right().toStdString()] { return open(rig, left, right); };
}

std::function<void(const steps::CamerasLearnt&)> CamerasPresenter::keeper() const {
  if (!chosen_.named() || !services_.keepLearnt) return nullptr;
  return [keep = services_.keepLearnt, name = rigName().toStdString()](const steps::CamerasLearnt& learnt) {
    keep(name, learnt);
  };
}

bool CamerasPresenter::canOpen() const { return chosen_.isComplete() && services_.openCameras; }

void CamerasPresenter::readAgain() {
  if (!rigName().isEmpty()) chosen_.readAgain();
}

OpenedCameras CamerasPresenter::chosenNow() const {
  return {*rig(), rigName(), left(), right(), chosen_.named().has_value()};
}

bool CamerasPresenter::isStillChosen() const {
  if (!opened_ || !rig()) return false;
  const OpenedCameras now = chosenNow();
  return now.rig_name == opened_->rig_name && now.left == opened_->left && now.right == opened_->right &&
         now.is_kept == opened_->is_kept && cameras::isSameCalibration(now.rig, opened_->rig);
}

QString CamerasPresenter::otherChoiceWords() const {
  if (!opened_ || isStillChosen()) return {};
  return tr("other cameras or another calibration are chosen now: open the cameras again (step 1)");
}

void CamerasPresenter::open() {
  if (!canOpen() || tasks_.isRunning()) return;  // if start() refused, the GUI thread would wait for `old`
  forgetStart();
  readAgain();
  if (!canOpen()) return emit changed();
  tasks_.start(tr("Opening the cameras"),
               [this, opens = opener(), chosen = chosenNow(),
                old = release()](TaskMonitor&) mutable -> TaskRunner::Delivery {
                 old.reset();  // first, because a camera can be opened only once
                 auto preview = std::make_shared<capture::LivePreview>(opens(), false);
                 return [this, preview, chosen] {
                   opened_ = chosen;  // not the present choice
                   preview_ = preview;
                   is_live_ = true;
                   emit opened();
                   emit changed();
                 };
               });
}

void CamerasPresenter::retire(std::shared_ptr<capture::LivePreview> preview) {
  if (preview)
    retirement_.add([old = std::move(preview)]() mutable { old.reset(); }, std::chrono::milliseconds(0));
}

void CamerasPresenter::forgetStart() { start_ = std::make_shared<LatestValue<steps::RigStart>>(); }

void CamerasPresenter::closeCameras() {
  forgetStart();
  if (auto preview = release())
    retirement_.add([old = std::move(preview)]() mutable { old.reset(); }, std::chrono::milliseconds(500));
  emit closed();
  emit changed();
}

void CamerasPresenter::show(const capture::Recording& recording) {
  retire(release());
  forgetStart();
  if (recording.frame_count > 0)
    preview_ = std::make_shared<capture::LivePreview>(capture::makeSource(recording), true);
  emit changed();
}

std::shared_ptr<capture::LivePreview> CamerasPresenter::release() {
  is_live_ = false;
  stills_.clear();
  return std::exchange(preview_, nullptr);
}

void CamerasPresenter::forgetPictures() {
  stills_.clear();
  emit changed();
}

std::shared_ptr<const cameras::StereoFrame> CamerasPresenter::picture() const {
  return preview_ ? preview_->latest() : nullptr;
}

bool CamerasPresenter::isWell() const {
  if (!preview_) return false;
  return preview_->failure().empty() && (!is_live_ || preview_->age_s() < kFresh_s);
}

QString CamerasPresenter::words() const {
  if (preview_) {
    if (!preview_->failure().empty()) return shownWords(preview_->failure());
    if (!is_live_) return preview_->hasEnded() ? tr("recording, at its end") : tr("recording");
    if (preview_->age_s() > kFresh_s) return tr("NO PICTURE from the cameras");
    QString words = tr("live, %1 pictures a second").arg(preview_->frames_per_s(), 0, 'f', 0);
    if (const QString start = startWords(); !start.isEmpty()) words += "\n" + start;
    if (const QString other = otherChoiceWords(); !other.isEmpty()) words += "\n" + other;
    for (const auto& caution : preview_->cautions()) words += "\n" + shownWords(caution);
    return words;
  }
  return chosen_.words();
}

/// Copy of the newest live pair. Refused if it is older than kFresh_s.
std::optional<cameras::StereoFrame> CamerasPresenter::takeFresh() {
  const auto frame = picture();
  if (!isLive() || !isWell() || !frame) {
    emit refused(tr("no fresh picture from the cameras: nothing was taken"));
    return std::nullopt;
  }
  cameras::StereoFrame fresh = *frame;
  fresh.left = frame->left.clone();
  fresh.right = frame->right.clone();
  return fresh;
}

void CamerasPresenter::takeDots() {
  const auto frame = takeFresh();
  frame ? stills_.takeDots(*frame) : stills_.clear();
  emit changed();
}

void CamerasPresenter::takePlain() {
  if (!stills_.hasDots()) return;
  if (const auto frame = takeFresh()) {
    const QString refusal = stills_.takePlain(*frame);
    if (!refusal.isEmpty()) emit refused(refusal);
  }
  emit changed();
  if (capture()) emit captureTaken();
}

void CamerasPresenter::takeMarked() {
  if (tasks_.isRunning()) return;
  if (!takeFresh()) return;  // takeFresh() has reported why
  stills_.clear();
  emit changed();
  tasks_.start(
      tr("Taking the picture"),
      [this, rig = opened_->rig, preview = preview_, coil = coil_ ? coil_() : coil_tracking::defaultCoil(),
       make = services_.makeSetupMethods](TaskMonitor& monitor) -> TaskRunner::Delivery {
        const auto methods = make();
        PreviewFrames frames(rig, preview);
        steps::AutomaticCapture still(rig, {methods.face_detector, methods.make_coil_tracker(), coil});
        steps::takeStillCapture(frames, still, kMarkedWithin_s, monitor);
        return [this, preview, taken = still.still()] {
          if (preview != preview_) return;  // other cameras were opened meanwhile
          stills_.take(taken);
          emit changed();
          emit captureTaken();
        };
      });
}

}  // namespace facenav::ui
