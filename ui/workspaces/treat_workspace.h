#pragma once
// Treat: 3-D scene, both cameras with overlays, bull's eye, figures legible from two metres. Steps: 1
// Cameras, 2 Align, 3 Guide. It takes the newest state about 30 times a second. If lost or old: figures
// blank, scene grey, and words say why.

#include <QTimer>
#include <QWidget>

#include "presenters/check_presenter.h"
#include "presenters/motor_presenter.h"
#include "presenters/return_presenter.h"
#include "presenters/session_sounds.h"

class QBoxLayout;
class QComboBox;
class QPushButton;
class QStackedWidget;

namespace facenav::ui {

class BullsEyeView;
class CameraRow;
class ElidedLabel;
class FiguresPanel;
class LiveSlices;
class PulseRow;
class SceneView;

class TreatWorkspace : public QWidget {
  Q_OBJECT

 public:
  /// Which panel stands beside the figures.
  enum class Tool { aim, motor, session };
  TreatWorkspace(TreatPresenter& presenter, CaseModel& model, QWidget* parent = nullptr);

  TreatPresenter& presenter() { return presenter_; }
  MotorPresenter& motor() { return motor_; }
  ReturnPresenter& sessionReturn() { return return_; }
  CheckPresenter& check() { return check_; }
  void showTool(Tool tool);

 signals:
  /// Emitted after each refresh, for the window's header.
  void shown(const facenav::ui::ReadOut& read_out);
  void toolShown(int tool);

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  QWidget* makeSide();
  QWidget* makeTabs(QWidget* parent);
  QWidget* makeSteps();
  void showCase();
  void showSteps();
  void showCoils();
  void refresh();
  void showStage(bool shows_cameras);
  void showPreview();
  void showSlicesInScene();
  void arrange();

  TreatPresenter& presenter_;
  CaseModel& model_;
  MotorPresenter motor_;
  ReturnPresenter return_;
  CheckPresenter check_;
  SessionSounds sounds_;
  SceneView* scene_;
  LiveSlices* slices_;
  CameraRow* pictures_;
  BullsEyeView* bulls_eye_;
  QBoxLayout* bulls_eye_and_figures_;
  FiguresPanel* figures_;
  QComboBox *target_, *coil_;
  QStackedWidget *side_, *tools_;  // tools_: bull's eye, motor, session
  QPushButton *cameras_, *align_, *guide_, *show_slices_, *slices_in_scene_;
  ElidedLabel* words_;
  PulseRow* pulses_;
  QTimer timer_;
  bool is_outdated_ = false, shows_running_ = false;
  std::int64_t previewed_ = -1;
  QString signature_;
};

}  // namespace facenav::ui
