#pragma once
// Treat: 3-D scene, both cameras with overlays, bull's eye, figures legible from two metres. Steps: 1
// Cameras, 2 Align, 3 Guide. It takes the newest state about 30 times a second. If lost or old: figures
// blank, scene grey, and words say why.

#include <QTimer>
#include <QWidget>

#include "presenters/treat_presenter.h"

class QBoxLayout;
class QComboBox;
class QLabel;
class QPushButton;
class QStackedWidget;

namespace facenav::ui {

class BullsEyeView;
class CameraRow;
class ElidedLabel;
class FiguresPanel;
class SceneView;

class TreatWorkspace : public QWidget {
  Q_OBJECT

 public:
  TreatWorkspace(TreatPresenter& presenter, CaseModel& model, QWidget* parent = nullptr);

  TreatPresenter& presenter() { return presenter_; }

 signals:
  /// Emitted after each refresh, for the window's header.
  void shown(const facenav::ui::ReadOut& read_out);

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  QWidget* makeSide();
  QWidget* makeSteps();
  void showCase();
  void showSteps();
  void refresh();
  void showStage(bool shows_cameras);
  void showPreview();
  void showSession();

  TreatPresenter& presenter_;
  CaseModel& model_;
  SceneView* scene_;
  CameraRow* pictures_;
  BullsEyeView* bulls_eye_;
  QBoxLayout* bulls_eye_and_figures_;
  FiguresPanel* figures_;
  QComboBox* target_;
  QStackedWidget* side_;
  QPushButton *cameras_, *align_, *guide_, *pulse_;
  ElidedLabel* words_;
  QLabel* pulses_;
  QTimer timer_;
  bool is_outdated_ = false, shows_running_ = false;
  std::int64_t previewed_ = -1;
  QString signature_, last_instruction_;
};

}  // namespace facenav::ui
