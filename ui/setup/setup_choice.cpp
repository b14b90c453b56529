// The choice of the cameras in the set-up: from those that are connected, by an address, or a kept pair.

#include <QRegularExpression>
#include <QSettings>
#include <QSize>
#include <algorithm>

#include "setup/setup_presenter.h"
#include "shell/shown_words.h"
#include "treat/camera_choice.h"

namespace facenav::ui {
namespace {

using Step = steps::SetupStep;

constexpr int kLeastSide_px = 64, kMostSide_px = 16384;

QString stableNameOf(const capture::FoundCamera& camera) {
  return QString::fromStdString(capture::stableName(camera.identity));
}

/// Reads "1280x720"; empty for anything else.
QSize sizeIn(const QString& text) {
  static const QRegularExpression kSize("^\\s*(\\d{2,5})\\s*[xX\u00d7]\\s*(\\d{2,5})\\s*$");
  const auto match = kSize.match(text);
  if (!match.hasMatch()) return {};
  const QSize size(match.captured(1).toInt(), match.captured(2).toInt());
  const bool is_usual = std::min(size.width(), size.height()) >= kLeastSide_px &&
                        std::max(size.width(), size.height()) <= kMostSide_px;
  return is_usual ? size : QSize();
}

}  // namespace

QStringList SetupPresenter::sizes() { return {"1280x720", "1920x1080", "640x480", "1024x1024"}; }

void SetupPresenter::lookForCameras() {
  if (!services_.listCameras || tasks_.isRunning()) return;
  tasks_.start(tr("Looking for cameras"), [this](TaskMonitor&) -> TaskRunner::Delivery {
    auto found = services_.listCameras(capture::Search::everywhere);
    return [this, found = std::move(found)] { takeDevices(found); };
  });
}

/// Deselects a camera that is gone. An address stays: no search finds it.
void SetupPresenter::takeDevices(std::vector<capture::FoundCamera> found) {
  devices_ = std::move(found);
  const auto is_there = [&](const QString& name) {
    return isAddress(name) || std::any_of(devices_.begin(), devices_.end(),
                                          [&](const auto& device) { return stableNameOf(device) == name; });
  };
  if (!is_there(left_)) left_.clear();
  if (!is_there(right_)) right_.clear();
  if (left_.isEmpty() && right_.isEmpty() && devices_.size() == 2) {
    left_ = stableNameOf(devices_[0]);
    right_ = stableNameOf(devices_[1]);
  }
  emit changed();
}

QString SetupPresenter::deviceWords() const {
  const auto advice = capture::adviceOn(devices_);
  return advice.empty() ? QString() : shownWords(advice.front());
}

QString SetupPresenter::choiceWords() const {
  if (!faults_.isEmpty()) return tr("the cameras are not open: see what is written below the fields");
  const bool are_typed = isAddress(left_) && isAddress(right_);
  if (canOpen()) return are_typed || deviceWords().isEmpty() ? tr("open the cameras") : deviceWords();
  const bool has_both = !left_.isEmpty() && !right_.isEmpty();
  if (has_both) return tr("these cameras cannot be opened: see what is written below the fields");
  if (deviceWords().isEmpty()) return tr("choose the left and the right camera, and open them");
  return deviceWords() + tr("; or type the address of a stream, a video or a folder of pictures");
}

QString SetupPresenter::trouble(SetupField field) const {
  if (faults_.contains(field)) return faults_[field];
  if (field == SetupField::name) return {};
  if (field == SetupField::size)
    return sizeIn(size_).isEmpty() ? tr("type width x height, as 1280x720") : QString();
  const QString& name = field == SetupField::left ? left_ : right_;
  if (name.isEmpty()) return {};
  if (field == SetupField::right && left_ == right_) return tr("this is the left camera: choose another");
  return addressTrouble(devices_, name);
}

void SetupPresenter::choose(const QString& left, const QString& right) {
  faults_.clear();
  for (const auto& [field, name, typed] :
       {std::tuple(SetupField::left, &left_, &left), {SetupField::right, &right_, &right}})
    try {
      *name = keptApart(*typed);
    } catch (const Error& error) {
      *name = shownCamera(*typed);
      faults_[field] = shownWords(error);
    }
  emit changed();
}

void SetupPresenter::chooseSize(const QString& size) {
  if (size == size_) return;
  size_ = size;
  faults_.clear();
  emit changed();
}

void SetupPresenter::swapSides() {
  std::swap(left_, right_);
  faults_.clear();
  if (isOpen() && opened_rig_.isEmpty())
    open();  // pictures taken with exchanged sides are invalid
  else
    emit changed();
}

bool SetupPresenter::canOpen() const {
  const bool is_right = trouble(SetupField::left).isEmpty() && trouble(SetupField::right).isEmpty() &&
                        trouble(SetupField::size).isEmpty();
  return !left_.isEmpty() && !right_.isEmpty() && (is_right || !faults_.isEmpty()) && left_ != right_ &&
         !sizeIn(size_).isEmpty() && services_.openNewCameras && !tasks_.isRunning();
}

/// Puts the words beside the field that caused them.
void SetupPresenter::blame(const steps::PairError& error) {
  const auto field = error.fault() == capture::CameraFault::wrong_size ? SetupField::size
                     : error.isLeft()                                  ? SetupField::left
                                                                       : SetupField::right;
  faults_[field] = shownWords(error);
  emit changed();
}

void SetupPresenter::open() {
  if (!canOpen()) return;
  QSettings().setValue("setup/size", size_);
  const QSize size = sizeIn(size_);
  opened_rig_.clear();
  faults_.clear();
  tasks_.start(tr("Opening the cameras: they adjust to the light"),
               [this, left = left_.toStdString(), right = right_.toStdString(), size,
                old = std::exchange(setup_, nullptr)](TaskMonitor&) mutable -> TaskRunner::Delivery {
                 old.reset();  // first, because a camera can be opened only once
                 try {
                   auto pair = std::make_shared<NewCameras>(
                       services_.openNewCameras(left, right, size.width(), size.height()));
                   return [this, pair] {
                     left_camera_ = pair->left;
                     right_camera_ = pair->right;
                     begin(std::move(pair->source), std::nullopt);
                   };
                 } catch (const steps::PairError& error) {
                   return [this, error] { blame(error); };
                 }
               });
}

QStringList SetupPresenter::rigNames() const {
  QStringList names;
  if (services_.listRigs)
    for (const auto& entry : services_.listRigs())
      if (entry.rig && entry.rig->left) names << QString::fromStdString(entry.name);
  return names;
}

void SetupPresenter::openKept(const QString& name) {
  if (tasks_.isRunning() || !services_.listRigs || !services_.openRig) return;
  std::optional<capture::NamedRig> rig;
  for (const auto& entry : services_.listRigs())
    if (entry.name == name.toStdString()) rig = entry.rig;
  if (!rig || !rig->left)
    return emit refused(tr("there is no rig called %1 that knows its cameras").arg(name));
  tasks_.start(
      tr("Opening the cameras"),
      [this, rig = *rig, old = std::exchange(setup_, nullptr)](TaskMonitor&) mutable -> TaskRunner::Delivery {
        old.reset();
        auto source = std::make_shared<std::unique_ptr<capture::FrameSource>>(services_.openRig(rig, {}));
        return [this, rig, source] {
          left_camera_ = rig.left;
          right_camera_ = rig.right;
          name_ = opened_rig_ = QString::fromStdString(rig.name);
          noted_.clear();
          begin(std::move(*source), rig.rig);
          go(Step::check);
        };
      });
}

}  // namespace facenav::ui
