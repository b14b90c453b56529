#include "treat/chosen_cameras.h"

#include <QDateTime>
#include <QFileInfo>
#include <QLocale>
#include <QSettings>
#include <algorithm>

#include "facenav/core/error.h"
#include "shell/shown_words.h"
#include "treat/camera_choice.h"

namespace facenav::ui {
namespace {

QString nameOf(const capture::FoundCamera& camera) {
  return QString::fromStdString(capture::stableName(camera.identity));
}

bool isOfNetwork(const QString& name) { return name.startsWith("genicam:"); }

const char* const kLeft = "cameras/left_name";
const char* const kRight = "cameras/right_name";
const char* const kRig = "cameras/rig";
const char* const kRigName = "cameras/rig_name";

}  // namespace

ChosenCameras::ChosenCameras(const Services& services, TaskRunner& tasks, QObject* parent)
    : QObject(parent), services_(services), tasks_(tasks) {
  const QSettings settings;
  left_ = shownCamera(settings.value(kLeft).toString());
  right_ = shownCamera(settings.value(kRight).toString());
  rig_file_ = settings.value(kRig).toString();
  rig_name_ = settings.value(kRigName).toString();
  readAgain();
}

void ChosenCameras::readAgain() {
  readRigs();
  readRig();
}

bool ChosenCameras::isComplete() const {
  return rig_ && !left_.isEmpty() && !right_.isEmpty() && left_ != right_;
}

void ChosenCameras::refreshDevices() {
  std::vector<capture::FoundCamera> found;
  if (services_.listCameras) found = services_.listCameras(capture::Search::quick);
  for (const auto& camera : devices_)  // network cameras do not answer a quick search
    if (isOfNetwork(nameOf(camera))) found.push_back(camera);
  use(std::move(found), false);
}

void ChosenCameras::lookEverywhere() {
  if (tasks_.isRunning() || !services_.listCameras) return refreshDevices();
  tasks_.start(tr("Looking for cameras"), [this](TaskMonitor&) -> TaskRunner::Delivery {
    auto found = services_.listCameras(capture::Search::everywhere);
    return [this, found = std::move(found)] { use(found, true); };
  });
}

/// Deselects a chosen camera that has vanished, unless this search could not find it or a rig names it.
void ChosenCameras::use(std::vector<capture::FoundCamera> devices, bool has_network) {
  devices_ = std::move(devices);
  const auto kept = [&](const QString& name) {
    const bool is_seen = device(name) || isAddress(name) || (!has_network && isOfNetwork(name));
    return is_seen || devices_.empty() ? name : QString();
  };
  QString left = named() ? left_ : kept(left_), right = named() ? right_ : kept(right_);
  if (left.isEmpty() && right.isEmpty() && devices_.size() == 2) {
    left = nameOf(devices_[0]);
    right = nameOf(devices_[1]);
  }
  if (left != left_ || right != right_) return choose(left, right);
  emit changed();
}

const capture::FoundCamera* ChosenCameras::device(const QString& name) const {
  const auto at =
      std::find_if(devices_.begin(), devices_.end(), [&](const auto& d) { return nameOf(d) == name; });
  return at == devices_.end() ? nullptr : &*at;
}

QString ChosenCameras::deviceWords() const {
  QStringList words;
  for (const auto& advice : capture::adviceOn(devices_)) words << shownWords(advice);
  return words.join("\n");
}

void ChosenCameras::choose(QString left, QString right) {
  try {
    left = keptApart(left);
    right = keptApart(right);
  } catch (const Error& error) {
    return emit refused(shownWords(error));
  }
  if (left != left_ || right != right_) forgetRigName();
  left_ = std::move(left);
  right_ = std::move(right);
  QSettings settings;
  settings.setValue(kLeft, left_);
  settings.setValue(kRight, right_);
  emit changed();
}

void ChosenCameras::setRigFile(const QString& path) {
  forgetRigName();
  rig_file_ = path;
  QSettings().setValue(kRig, path);
  readRig();
  emit changed();
}

void ChosenCameras::readRigs() {
  rigs_.clear();
  if (!services_.listRigs) return;
  try {
    rigs_ = services_.listRigs();
  } catch (const Error& error) {
    rig_problem_ = shownWords(error);
  }
}

QStringList ChosenCameras::rigNames() const {
  QStringList names;
  for (const auto& entry : rigs_) names << QString::fromStdString(entry.name);
  return names;
}

/// Returns the chosen rig if it can be read and lists its cameras.
std::optional<capture::NamedRig> ChosenCameras::named() const {
  for (const auto& entry : rigs_)
    if (!rig_name_.isEmpty() && entry.name == rig_name_.toStdString() && entry.rig && entry.rig->left)
      return entry.rig;
  return std::nullopt;
}

void ChosenCameras::forgetRigName() {
  rig_name_.clear();
  QSettings().remove(kRigName);
}

void ChosenCameras::chooseRig(const QString& name) {
  readRigs();
  const auto at = std::find_if(rigs_.begin(), rigs_.end(),
                               [&](const auto& entry) { return entry.name == name.toStdString(); });
  if (at == rigs_.end() || !at->rig)
    return emit refused(at == rigs_.end() ? tr("there is no rig called %1").arg(name)
                                          : shownWords(at->problem));
  setRigFile(QString::fromStdString((at->folder / "stereo.yml").string()));
  if (at->rig->left)
    choose(QString::fromStdString(capture::stableName(at->rig->left->identity)),
           QString::fromStdString(capture::stableName(at->rig->right->identity)));
  rig_name_ = name;
  rig_ = at->rig->rig;  // with the measured row times
  QSettings().setValue(kRigName, name);
  emit changed();
}

void ChosenCameras::readRig() {
  rig_.reset();
  rig_problem_.clear();
  if (rig_file_.isEmpty()) return;
  try {
    rig_ = cameras::readRig(rig_file_.toStdString());
    if (const auto kept = named()) rig_ = kept->rig;  // with the measured row times
  } catch (const Error& error) {
    rig_problem_ = shownWords(error);
  }
}

/// Words of the last check; a check of an earlier day does not cover a bar that was bumped since.
QString ChosenCameras::checkWords(const capture::NamedRig& rig) const {
  if (!rig.last_check) return tr("never checked since it was made: check it (Set up)");
  const QString words = tr("last check: %1").arg(shownWords(rig.last_check->words));
  const auto checked = QDateTime::fromString(QString::fromStdString(rig.last_check->utc), Qt::ISODate);
  if (!checked.isValid() || checked.date() == QDateTime::currentDateTimeUtc().date()) return words;
  return words + tr(" (%1); check it again today (Set up)")
                     .arg(QLocale().toString(checked.date(), QLocale::ShortFormat));
}

QString ChosenCameras::rigWords(bool is_open) const {
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
  // While the rig's cameras are open, their own verification is more recent.
  if (const auto kept = named(); kept && !is_open) words += "\n" + checkWords(*kept);
  return words;
}

QString ChosenCameras::words() const {
  const bool are_connected = !isAddress(left_) && !isAddress(right_);
  if (devices_.empty() && are_connected)
    return tr("no camera found: plug two cameras in and look again, or open a recording");
  if (devices_.size() < 2 && are_connected) return deviceWords();
  for (const QString& name : {left_, right_})
    if (const auto* chosen = device(name); chosen && chosen->use != capture::FoundCamera::Use::free)
      return deviceWords();
  if (left_.isEmpty() || right_.isEmpty() || left_ == right_) return tr("choose two different cameras");
  if (!rig_) return tr("choose the calibration of these two cameras");
  for (const QString& name : {left_, right_})
    if (const QString trouble = addressTrouble(devices_, name); !trouble.isEmpty()) return trouble;
  const QString advice = are_connected ? deviceWords() : QString();
  return advice.isEmpty() ? tr("ready to be opened") : tr("ready to be opened; %1").arg(advice);
}

}  // namespace facenav::ui
