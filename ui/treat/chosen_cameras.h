#pragma once
// ChosenCameras: which two cameras are used, with which calibration: chosen one by one, or together as a kept
// rig (`facenav rig new`). Remembered.

#include <QObject>
#include <QStringList>
#include <optional>
#include <vector>

#include "facenav/cameras/stereo_rig.h"
#include "facenav/capture/camera_backend.h"
#include "shell/services.h"
#include "shell/task_runner.h"

namespace facenav::ui {

class ChosenCameras : public QObject {
  Q_OBJECT

 public:
  ChosenCameras(const Services& services, TaskRunner& tasks, QObject* parent = nullptr);

  /// Updates the list of connected cameras at once. Network cameras stay as last found.
  void refreshDevices();
  /// Also searches the network for cameras, in the background.
  void lookEverywhere();
  const std::vector<capture::FoundCamera>& devices() const { return devices_; }
  /// Notes on the connected cameras, or what to do; empty if there are none.
  QString deviceWords() const;
  /// Stable name of the chosen camera (capture/camera.h), empty: none.
  QString left() const { return left_; }
  QString right() const { return right_; }
  void choose(QString left, QString right);  // by value: swapSides passes the members
  void swapSides() { choose(right_, left_); }

  /// Names of the kept rigs.
  QStringList rigNames() const;
  /// Name of the chosen rig; empty if cameras and calibration were chosen one by one.
  QString rigName() const { return rig_name_; }
  /// Takes the rig's cameras, settings and calibration.
  void chooseRig(const QString& name);
  /// The chosen rig, if it can be read and lists its cameras.
  std::optional<capture::NamedRig> named() const;
  /// Path of the rig's stereo.yml.
  QString rigFile() const { return rig_file_; }
  void setRigFile(const QString& path);
  const std::optional<cameras::StereoRig>& rig() const { return rig_; }
  /// Reads the kept rigs and the calibration again.
  void readAgain();
  /// "1280 x 720 px, 119.8 mm apart, 0.21 px, of 20 Nov 2026", or what is wrong with the file; with the last
  /// check of a kept rig whose cameras are not open.
  QString rigWords(bool is_open) const;

  /// True if two cameras and their calibration are chosen.
  bool isComplete() const;
  /// What to do until the cameras can be opened: "no camera found: ..".
  QString words() const;

 signals:
  void changed();
  void refused(const QString& words);

 private:
  void use(std::vector<capture::FoundCamera> devices, bool has_network);
  QString checkWords(const capture::NamedRig& rig) const;
  const capture::FoundCamera* device(const QString& name) const;
  void readRig();
  void readRigs();
  void forgetRigName();

  const Services& services_;
  TaskRunner& tasks_;
  std::vector<capture::FoundCamera> devices_;
  QString left_, right_;
  std::vector<capture::RigEntry> rigs_;
  QString rig_name_, rig_file_, rig_problem_;
  std::optional<cameras::StereoRig> rig_;
};

}  // namespace facenav::ui
