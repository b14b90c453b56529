#include "presenters/cameras_presenter.h"

#include <QDateTime>
#include <QFileInfo>
#include <QLocale>
#include <QSettings>
#include <algorithm>

#include "facenav/core/error.h"
#include "facenav/workflow/marked_still.h"
#include "presenters/preview_frames.h"

namespace facenav::ui {
namespace {

QString nameOf(const capture::FoundCamera& camera) {
  return QString::fromStdString(capture::stableName(camera.identity));
}

bool isOfNetwork(const QString& name) { return name.startsWith("genicam:"); }

constexpr double kFresh_s = 0.5;  // an older image does not show the present
constexpr double kMarkedWithin_s = 60.0;
const char* const kLeft = "cameras/left_name";
const char* const kRight = "cameras/right_name";
const char* const kRig = "cameras/rig";
const char* const kRigName = "cameras/rig_name";

}  // namespace

CamerasPresenter::CamerasPresenter(const Services& services, TaskRunner& tasks, QObject* parent)
    : QObject(parent), services_(services), tasks_(tasks) {
  const QSettings settings;
  left_ = settings.value(kLeft).toString();
  right_ = settings.value(kRight).toString();
  rig_file_ = settings.value(kRig).toString();
  rig_name_ = settings.value(kRigName).toString();
  readRigs();
  readRig();
}

void CamerasPresenter::refreshDevices() {
  std::vector<capture::FoundCamera> found;
  if (services_.listCameras) found = services_.listCameras(capture::Search::quick);
  for (const auto& camera : devices_)  // these do not answer a quick search
    if (isOfNetwork(nameOf(camera))) found.push_back(camera);
  use(std::move(found), false);
}

void CamerasPresenter::lookEverywhere() {
  if (tasks_.isRunning() || isLive() || !services_.listCameras) return refreshDevices();
  tasks_.start(tr("Looking for cameras"), [this](TaskMonitor&) -> TaskRunner::Delivery {
    auto found = services_.listCameras(capture::Search::everywhere);
    return [this, found = std::move(found)] { use(found, true); };
  });
}

/// A chosen camera that is gone is no longer chosen, unless this search could not have found it, or a rig
/// names it.
void CamerasPresenter::use(std::vector<capture::FoundCamera> devices, bool has_network) {
  devices_ = std::move(devices);
  const auto kept = [&](const QString& name) {
    return device(name) || (!has_network && isOfNetwork(name)) || devices_.empty() ? name : QString();
  };
  QString left = namedRig() ? left_ : kept(left_), right = namedRig() ? right_ : kept(right_);
  if (left.isEmpty() && right.isEmpty() && devices_.size() == 2) {
    left = nameOf(devices_[0]);
    right = nameOf(devices_[1]);
  }
  if (left != left_ || right != right_) return choose(left, right);
  emit changed();
}

const capture::FoundCamera* CamerasPresenter::device(const QString& name) const {
  const auto at =
      std::find_if(devices_.begin(), devices_.end(), [&](const auto& d) { return nameOf(d) == name; });
  return at == devices_.end() ? nullptr : &*at;
}

QString CamerasPresenter::deviceWords() const {
  QStringList words;
  for (const auto& advice : capture::adviceOn(devices_)) words << QString::fromStdString(advice);
  return words.join("\n");
}

void CamerasPresenter::choose(QString left, QString right) {
  if (left != left_ || right != right_) forgetRigName();
  left_ = std::move(left);
  right_ = std::move(right);
  QSettings settings;
  settings.setValue(kLeft, left_);
  settings.setValue(kRight, right_);
  emit changed();
}

void CamerasPresenter::setRigFile(const QString& path) {
  forgetRigName();
  rig_file_ = path;
  QSettings().setValue(kRig, path);
  readRig();
  emit changed();
}

void CamerasPresenter::readRigs() {
  rigs_.clear();
  if (!services_.listRigs) return;
  try {
    rigs_ = services_.listRigs();
  } catch (const Error& error) {
    rig_problem_ = QString::fromUtf8(error.what());
  }
}

QStringList CamerasPresenter::rigNames() const {
  QStringList names;
  for (const auto& entry : rigs_) names << QString::fromStdString(entry.name);
  return names;
}

/// The chosen one, if it can be read and knows its cameras.
std::optional<capture::NamedRig> CamerasPresenter::namedRig() const {
  for (const auto& entry : rigs_)
    if (!rig_name_.isEmpty() && entry.name == rig_name_.toStdString() && entry.rig && entry.rig->left)
      return entry.rig;
  return std::nullopt;
}

void CamerasPresenter::forgetRigName() {
  rig_name_.clear();
  QSettings().remove(kRigName);
}

void CamerasPresenter::chooseRig(const QString& name) {
  readRigs();
  const auto at = std::find_if(rigs_.begin(), rigs_.end(),
                               [&](const auto& entry) { return entry.name == name.toStdString(); });
  if (at == rigs_.end() || !at->rig)
    return emit refused(at == rigs_.end() ? tr("there is no rig called %1").arg(name)
                                          : QString::fromStdString(at->problem));
  setRigFile(QString::fromStdString((at->folder / "stereo.yml").string()));
  if (at->rig->left)
    choose(QString::fromStdString(capture::stableName(at->rig->left->identity)),
           QString::fromStdString(capture::stableName(at->rig->right->identity)));
  rig_name_ = name;
  rig_ = at->rig->rig;  // with the row times that were measured
  QSettings().setValue(kRigName, name);
  emit changed();
}

/// What is found is read by the window's own thread.
RigVerifying CamerasPresenter::verifying() const {
  RigVerifying verifying;
  if (coil_) verifying.coil = coil_();
  verifying.told = [start = start_](const workflow::RigStart& found) {
    start->publish(std::make_shared<const workflow::RigStart>(found));
  };
  return verifying;
}

QString CamerasPresenter::rigFault() const {
  if (const auto frame = picture(); frame && is_live_ && !frame->rig_fault.empty())
    return QString::fromStdString(frame->rig_fault);
  const auto found = start_->latest();
  return found && found->isWithheld() ? QString::fromStdString(found->words()) : QString();
}

QString CamerasPresenter::startWords() const {
  if (!namedRig()) return {};
  const auto found = start_->latest();
  return found ? QString::fromStdString(found->words())
               : tr("the cameras are compared with what was kept: look at them, and hold the coil still");
}

std::function<std::unique_ptr<capture::FrameSource>()> CamerasPresenter::opener() const {
  if (const auto named = namedRig(); named && services_.openRig)
    return [open = services_.openRig, rig = *named, verifying = verifying()] { return open(rig, verifying); };
  FACENAV_EXPECT(rig_, "a calibration is chosen first");
  return [open = services_.openCameras, rig = *rig_, left = left_.toStdString(),
          right = right_.toStdString()] { return open(rig, left, right); };
}

std::function<void(const workflow::CamerasLearnt&)> CamerasPresenter::keeper() const {
  if (!namedRig() || !services_.keepLearnt) return nullptr;
  return [keep = services_.keepLearnt,
          name = rig_name_.toStdString()](const workflow::CamerasLearnt& learnt) { keep(name, learnt); };
}

void CamerasPresenter::readRig() {
  rig_.reset();
  rig_problem_.clear();
  if (rig_file_.isEmpty()) return;
  try {
    rig_ = cameras::readRig(rig_file_.toStdString());
    if (const auto named = namedRig()) rig_ = named->rig;  // with the row times that were measured
  } catch (const Error& error) {
    rig_problem_ = QString::fromUtf8(error.what());
  }
}

/// A check of an earlier day says nothing of a bar that was bumped since.
QString CamerasPresenter::checkWords(const capture::NamedRig& rig) const {
  if (!rig.last_check) return tr("never checked since it was made: check it (Set up)");
  const QString words = tr("last check: %1").arg(QString::fromStdString(rig.last_check->words));
  const auto checked = QDateTime::fromString(QString::fromStdString(rig.last_check->utc), Qt::ISODate);
  if (!checked.isValid() || checked.date() == QDateTime::currentDateTimeUtc().date()) return words;
  return words + tr(" (%1); check it again today (Set up)")
                     .arg(QLocale().toString(checked.date(), QLocale::ShortFormat));
}

QString CamerasPresenter::rigWords() const {
  if (rig_file_.isEmpty())
    return tr("no calibration yet: set up the cameras, or choose the stereo.yml of these two cameras");
  if (!rig_) return rig_problem_;
  QString words = tr("%1 x %2 px, %3 mm apart")
                      .arg(rig_->width_px)
                      .arg(rig_->height_px)
                      .arg(rig_->baseline_mm(), 0, 'f', 1);
  if (rig_->rms_px) words += tr(", %1 px rms").arg(*rig_->rms_px, 0, 'f', 2);
  words +=
      tr(", of %1").arg(QLocale().toString(QFileInfo(rig_file_).lastModified().date(), QLocale::ShortFormat));
  // While its cameras are open, what was found now says more (words()).
  if (const auto named = namedRig(); named && !is_live_) words += "\n" + checkWords(*named);
  return words;
}

bool CamerasPresenter::canOpen() const {
  return rig_ && !left_.isEmpty() && !right_.isEmpty() && left_ != right_ && services_.openCameras;
}

void CamerasPresenter::open() {
  if (!canOpen() || tasks_.isRunning()) return;  // if start() refused, the GUI thread would wait for `old`
  forgetStart();
  if (!rig_name_.isEmpty()) {  // with what the last session kept with it
    readRigs();
    readRig();
  }
  if (!canOpen()) return emit changed();
  tasks_.start(tr("Opening the cameras"),
               [this, opens = opener(), old = release()](TaskMonitor&) mutable -> TaskRunner::Delivery {
                 old.reset();  // first: a camera can be opened only once
                 auto preview = std::make_shared<capture::LivePreview>(opens(), false);
                 return [this, preview] {
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

void CamerasPresenter::forgetStart() { start_ = std::make_shared<LatestValue<workflow::RigStart>>(); }

void CamerasPresenter::closeCameras() {
  forgetStart();
  if (auto preview = release())
    retirement_.add([old = std::move(preview)]() mutable { old.reset(); }, std::chrono::milliseconds(500));
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

std::shared_ptr<const cameras::StereoFrame> CamerasPresenter::picture() const {
  return preview_ ? preview_->latest() : nullptr;
}

bool CamerasPresenter::isWell() const {
  if (!preview_) return false;
  return preview_->failure().empty() && (!is_live_ || preview_->age_s() < kFresh_s);
}

QString CamerasPresenter::words() const {
  if (preview_) {
    if (!preview_->failure().empty()) return QString::fromStdString(preview_->failure());
    if (!is_live_) return preview_->hasEnded() ? tr("recording, at its end") : tr("recording");
    if (preview_->age_s() > kFresh_s) return tr("NO PICTURE from the cameras");
    QString words = tr("live, %1 pictures a second").arg(preview_->frames_per_s(), 0, 'f', 0);
    if (const QString start = startWords(); !start.isEmpty()) words += "\n" + start;
    for (const auto& caution : preview_->cautions()) words += "\n" + QString::fromStdString(caution);
    return words;
  }
  return notReadyWords();
}

QString CamerasPresenter::notReadyWords() const {
  if (devices_.empty()) return tr("no camera found: plug two cameras in and look again, or open a recording");
  if (devices_.size() < 2) return deviceWords();
  for (const QString& name : {left_, right_})
    if (const auto* chosen = device(name); chosen && chosen->use != capture::FoundCamera::Use::free)
      return deviceWords();
  if (left_.isEmpty() || right_.isEmpty() || left_ == right_) return tr("choose two different cameras");
  if (!rig_) return tr("choose the calibration of these two cameras");
  const QString advice = deviceWords();
  return advice.isEmpty() ? tr("ready to be opened") : tr("ready to be opened; %1").arg(advice);
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
  if (!takeFresh() || !rig_) return;  // no live picture: that was said
  stills_.clear();
  emit changed();
  tasks_.start(tr("Taking the picture"),
               [this, rig = *rig_, preview = preview_, coil = coil_ ? coil_() : coil_tracking::defaultCoil(),
                make = services_.makeSetupMethods](TaskMonitor& monitor) -> TaskRunner::Delivery {
                 const auto methods = make();
                 PreviewFrames frames(rig, preview);
                 workflow::MarkedStill still(rig, {methods.face_detector, methods.make_coil_tracker(), coil});
                 workflow::takeMarkedStill(frames, still, kMarkedWithin_s, monitor);
                 return [this, preview, taken = still.still()] {
                   if (preview != preview_) return;  // other cameras meanwhile
                   stills_.take(taken);
                   emit changed();
                   emit captureTaken();
                 };
               });
}

}  // namespace facenav::ui
