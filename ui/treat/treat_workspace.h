#pragma once
// Treat: 3-D scene, both cameras with overlays, bull's eye, figures legible from two metres. Steps: 1
// Cameras, 2 Align, 3 Guide. It takes the newest state about 30 times a second. If lost or outdated, figures
// are blank, the scene is grey, and words give the reason.

#include <QTimer>
#include <QWidget>

#include "shell/drawing_share.h"
#include "treat/check_presenter.h"
#include "treat/live_field_presenter.h"
#include "treat/motor_presenter.h"
#include "treat/return_presenter.h"
#include "treat/session_sounds.h"
#include "treat/tip_presenter.h"
#include "treat/treat_side.h"

class QComboBox;
class QPushButton;
class QStackedWidget;

namespace facenav::ui {

class CameraRow;
class ElidedLabel;
class LiveFieldView;
class LiveSlices;
class PausePanel;
class SceneView;

class TreatWorkspace : public QWidget {
  Q_OBJECT

 public:
  using Tool = TreatSide::Tool;
  TreatWorkspace(TreatPresenter& presenter, CaseModel& model, QWidget* parent = nullptr);

  TreatPresenter& presenter() { return presenter_; }
  MotorPresenter& motor() { return motor_; }
  ReturnPresenter& sessionReturn() { return return_; }
  CheckPresenter& check() { return check_; }
  TipPresenter& tip() { return tip_; }
  LiveFieldPresenter& field() { return field_; }
  ProjectorPresenter& projector() { return projector_; }
  SecondScreens& screens() { return *screens_; }
  void showTool(Tool tool);

 signals:
  /// Emitted after each refresh, for the window's header.
  void shown(const facenav::ui::ReadOut& read_out);

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  QWidget* makeSide();
  QWidget* makeSteps();
  void makeStepButtons(QWidget* bar);
  void makeChoices(QWidget* bar);
  void connectSteps();
  void showCase();
  bool hasMoved() const;  // true if a kept rig has moved: no alignment or guidance with it
  void showSteps();
  void showCoils();
  void refresh();
  std::shared_ptr<const session::NavigationState> shownState() const;
  ReadOut readOut(const session::NavigationState& state, bool was_started) const;
  void draw(const std::shared_ptr<const session::NavigationState>& state, const ReadOut& read_out,
            bool was_started);
  void followState(const std::shared_ptr<const session::NavigationState>& state, const ReadOut& read_out);
  void drawScene(const session::NavigationState& state, const ReadOut& read_out, bool was_started);
  void showStage(bool shows_cameras);
  void showPreview();
  void showSlicesInScene();
  void makeViewSwitches(QWidget* bar);
  void connectField();
  void drawField();
  void showPictures(const std::shared_ptr<const session::NavigationState>& state, bool was_started);

  TreatPresenter& presenter_;
  CaseModel& model_;
  MotorPresenter motor_;
  ReturnPresenter return_;
  CheckPresenter check_;
  TipPresenter tip_;
  ProjectorPresenter projector_;
  LiveFieldPresenter field_;
  SecondScreens* screens_;
  SessionSounds sounds_;
  SceneView* scene_;
  std::unique_ptr<scene::FieldLayer> field_layer_;
  LiveFieldView* field_view_;
  PausePanel* pause_;
  LiveSlices* slices_;
  CameraRow* pictures_;
  TreatSide* tools_;  // Aim, Motor, Session, Check
  QComboBox *target_, *coil_;
  QStackedWidget* side_;
  QPushButton *cameras_, *align_, *guide_, *end_, *show_slices_, *slices_in_scene_, *show_field_;
  ElidedLabel* words_;
  QTimer timer_;
  bool is_outdated_ = false, shows_running_ = false, shows_aligned_ = false, shows_moved_ = false;
  std::int64_t previewed_ = -1, drawn_field_ = -1;  // frames; of a field: -1: none is drawn
  QString signature_, words_in_scene_;              // of what is shown; empty: draw anew
  bool is_scene_behind_ = false;                    // the scene does not show the newest state yet
  DrawingShare scene_share_;
};

}  // namespace facenav::ui
