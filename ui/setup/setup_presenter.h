#pragma once
// SetupPresenter: the set-up of a camera pair in four steps (setup/rig_setup.h): which two cameras, the
// steps, and the rig that is kept under a name at the end. A kept rig is opened at its check.

#include <QMap>
#include <QObject>
#include <QStringList>
#include <memory>
#include <optional>

#include "facenav/coil_library/coil_library.h"
#include "facenav/setup/rig_setup.h"
#include "facenav/setup/settle_camera.h"
#include "shell/asynchronous_shutdown.h"
#include "shell/services.h"
#include "shell/task_runner.h"

namespace facenav::ui {

/// Fields of the set-up that can be filled in wrongly.
enum class SetupField { left, right, size, name };

class SetupPresenter : public QObject {
  Q_OBJECT

 public:
  SetupPresenter(const Services& services, TaskRunner& tasks, QObject* parent = nullptr);
  ~SetupPresenter() override;

  // Choice of the cameras.
  void lookForCameras();
  const std::vector<capture::FoundCamera>& devices() const { return devices_; }
  /// Notes on the connected cameras, or what to do; empty if there are none.
  QString deviceWords() const;
  /// Stable name of a camera, or an address as typed.
  QString left() const { return left_; }
  QString right() const { return right_; }
  /// What is wrong in this field, or was when the cameras were opened or kept; empty if nothing is.
  QString trouble(SetupField field) const;
  void choose(const QString& left, const QString& right);
  void swapSides();
  static QStringList sizes();
  /// Takes a size as listed or typed: "1280x720".
  void chooseSize(const QString& size);
  QString chosenSize() const { return size_; }
  bool canOpen() const;
  void open();
  QStringList rigNames() const;
  /// Opens a kept rig's cameras and checks it.
  void openKept(const QString& name);
  bool isOpen() const { return setup_ != nullptr; }

  // The steps.
  steps::SetupStep step() const { return step_; }
  void go(steps::SetupStep step);
  /// Returns false if an earlier step is not complete.
  bool canGo(steps::SetupStep step) const;
  /// What the newest pair shows; without pictures before the first pair.
  std::shared_ptr<const steps::SetupView> view() const;
  /// Sentence of the running step, or what must come first.
  QString sentence() const;

  // Calibrate.
  const cameras::Board& board() const { return board_; }
  void setBoard(int columns, int rows, double square_mm);
  void finishViews();
  void takeMoreViews();
  /// Discards all views and starts again, also for the two-minute repair of a bar that was bumped.
  void repeatViews();
  /// "+-0.42 mm at 600 mm"; empty if not calibrated.
  QString resultWords() const;
  bool printBoard(const QString& file);

  // Keep.
  QString name() const { return name_; }
  void setName(const QString& name) {
    name_ = name;
    faults_.remove(SetupField::name);
  }
  /// Saves the calibration if its check passes. `replaces`: a rig of this name is replaced.
  bool keep(bool replaces);
  bool isKept() const { return is_kept_; }
  /// Stores the check of an opened kept rig as soon as it is available. Call it regularly.
  void noteCheckOfKept();
  bool isNameTaken() const;

  // Coil.
  QStringList coilNames() const;
  void chooseCoil(const QString& name);
  QString coilName() const { return coil_name_; }
  void startPivots();
  void startJig(const QString& file);
  /// Measures the cameras' rolling shutter on the waved coil.
  void startWave();
  /// Stores the row times measured on the waved coil as soon as they are available. Call it regularly.
  void keepRowTimes();
  /// Adds the calibrated coil to the library under the chosen name.
  bool keepCoil();

  /// Closes the cameras.
  void close();

 signals:
  void changed();
  void refused(const QString& words);
  void kept(const QString& name);

 private:
  QString choiceWords() const;
  void takeDevices(std::vector<capture::FoundCamera> found);
  void blame(const steps::PairError& error);
  void begin(std::unique_ptr<capture::FrameSource> source, std::optional<cameras::StereoRig> rig);
  const coil_library::LibraryCoil* coil() const;
  capture::NamedRig named() const;

  const Services& services_;
  TaskRunner& tasks_;
  std::vector<capture::FoundCamera> devices_;
  QString left_, right_, size_, name_, coil_name_;
  cameras::Board board_{9, 6, 25.0};
  std::optional<capture::RigCamera> left_camera_, right_camera_;
  QMap<SetupField, QString> faults_;  // found when the cameras were opened or kept
  std::vector<coil_library::LibraryCoil> coils_;
  std::shared_ptr<steps::RigSetup> setup_;
  steps::SetupStep step_ = steps::SetupStep::place;
  QString opened_rig_;  // name of the opened kept rig; empty if none is open, or if it is being repaired
  std::string noted_;   // words of the stored check
  bool is_kept_ = false;
  std::optional<std::array<double, 2>> kept_row_times_s_;
  AsynchronousShutdown retirement_;
};

}  // namespace facenav::ui
