#pragma once
// CamerasPresenter: step 1 of Treat: the chosen cameras (chosen_cameras.h) and what they see. It also takes
// the still pictures for the alignment. A recording is shown in the same way.

#include <QObject>
#include <QStringList>
#include <functional>
#include <memory>
#include <optional>

#include "facenav/capture/camera_backend.h"
#include "facenav/capture/live_preview.h"
#include "facenav/capture/recording.h"
#include "facenav/core/latest_value.h"
#include "shell/asynchronous_shutdown.h"
#include "shell/services.h"
#include "shell/task_runner.h"
#include "treat/chosen_cameras.h"
#include "treat/still_pictures.h"

namespace facenav::ui {

/// Names of the cameras and the rig that were opened.
struct OpenedCameras {
  cameras::StereoRig rig;
  QString rig_name, left, right;  // rig_name empty: chosen one by one
  bool is_kept = false;           // opened as the kept rig, with its settings and its verification
};

class CamerasPresenter : public QObject {
  Q_OBJECT

 public:
  CamerasPresenter(const Services& services, TaskRunner& tasks, QObject* parent = nullptr);

  // Choice of cameras and calibration (chosen_cameras.h).
  void refreshDevices() { chosen_.refreshDevices(); }
  void lookEverywhere();
  const std::vector<capture::FoundCamera>& devices() const { return chosen_.devices(); }
  QString deviceWords() const { return chosen_.deviceWords(); }
  QString left() const { return chosen_.left(); }
  QString right() const { return chosen_.right(); }
  void choose(const QString& left, const QString& right) { chosen_.choose(left, right); }
  void swapSides() { chosen_.swapSides(); }
  QStringList rigNames() const { return chosen_.rigNames(); }
  QString rigName() const { return chosen_.rigName(); }
  void chooseRig(const QString& name) { chosen_.chooseRig(name); }
  QString rigFile() const { return chosen_.rigFile(); }
  void setRigFile(const QString& path) { chosen_.setRigFile(path); }
  const std::optional<cameras::StereoRig>& rig() const { return chosen_.rig(); }
  QString rigWords() const { return chosen_.rigWords(is_live_); }
  bool isRigGood() const { return rig().has_value(); }

  bool canOpen() const;
  /// Sets the coil whose marker verifies a kept rig when its cameras open; without it the default coil.
  void useCoilOf(std::function<coil_tracking::CoilModel()> coil) { coil_ = std::move(coil); }
  /// Why guidance and alignment with the live cameras are withheld: the kept rig has moved. Empty if no fault
  /// is known.
  QString rigFault() const;
  /// Function that opens the present choice; for another thread.
  std::function<std::unique_ptr<capture::FrameSource>()> opener() const;
  /// Function that stores what a session learnt with the chosen rig; null if none is chosen or it cannot be
  /// stored.
  std::function<void(const steps::CamerasLearnt&)> keeper() const;
  /// Opens both cameras and starts the live images.
  void open();
  /// The choice with which the cameras were opened last; empty if they were never opened.
  const std::optional<OpenedCameras>& lastOpened() const { return opened_; }
  /// Returns false if other cameras or another calibration are chosen than were opened last.
  bool isStillChosen() const;
  /// What to do if isStillChosen() is false; empty otherwise.
  QString otherChoiceWords() const;
  /// Reads the chosen kept rig again, with what a session or the set-up stored with it.
  void readAgain();
  /// Plays a recording as a preview.
  void show(const capture::Recording& recording);
  /// Asks for the window that sets up a camera pair (setup/setup_window.h), to check the chosen rig.
  void askForSetUp() { emit setUpWanted(rigName()); }
  /// Stops showing images and returns what must be released, or null. Release it off the GUI thread: a camera
  /// that gives no image blocks the thread that releases it.
  std::shared_ptr<capture::LivePreview> release();
  /// Stops the live images for something else that uses the cameras; waits at most half a second. Not while
  /// a task runs: it may hold the cameras.
  void closeCameras();
  bool mayClose() const { return !tasks_.isRunning(); }
  bool isLive() const { return is_live_ && preview_; }
  bool hasPictures() const { return preview_ != nullptr; }
  /// The newest pair, or null.
  std::shared_ptr<const cameras::StereoFrame> picture() const;
  /// State of the cameras, or what to do: "no camera found: ..".
  QString words() const;
  /// False if `words` asks the user to do something.
  bool isWell() const;

  /// Stores the newest live pair as the one with dots, or without. Refused if there is no fresh image.
  void takeDots();
  void takePlain();
  /// Takes the pair by automatic capture (align/automatic_capture.h), without a projector: when both cameras
  /// see the face and, at rest beside it, the coil's marker. Can be cancelled as a task.
  void takeMarked();
  bool hasDots() const { return stills_.hasDots(); }
  /// Both pairs, if taken within 20 s of each other.
  std::optional<capture::CapturePair> capture() const { return stills_.capture(); }
  QString captureWords() const { return stills_.words(); }
  /// Discards the pictures, because they show another patient.
  void forgetPictures();

 signals:
  void changed();
  /// Both cameras deliver images through openCameras.
  void opened();
  /// The cameras were closed; they may have another position or calibration when opened again. Not emitted if
  /// a session takes them over.
  void closed();
  void captureTaken();
  void setUpWanted(const QString& rig);
  void refused(const QString& words);

 private:
  void retire(std::shared_ptr<capture::LivePreview> preview);
  void forgetStart();
  OpenedCameras chosenNow() const;
  RigVerifying verifying() const;
  /// Result of the kept rig's verification; empty if none is open.
  QString startWords() const;
  std::optional<cameras::StereoFrame> takeFresh();

  const Services& services_;
  TaskRunner& tasks_;
  ChosenCameras chosen_;
  std::optional<OpenedCameras> opened_;
  std::shared_ptr<capture::LivePreview> preview_;
  AsynchronousShutdown retirement_;
  bool is_live_ = false;
  std::function<coil_tracking::CoilModel()> coil_;
  /// Result for the cameras opened last; without a value while it is pending.
  std::shared_ptr<LatestValue<steps::RigStart>> start_ = std::make_shared<LatestValue<steps::RigStart>>();
  StillPictures stills_;
};

}  // namespace facenav::ui
