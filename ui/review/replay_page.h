#pragma once
// ReplayPage: plays a session back: the scene with the coil as it was, both camera pictures, figures of
// guidance.csv; play, pause, step, and a band to scrub. If head or coil is lost, the scene is grey, the coil
// and the figures are removed, and words give the reason.

#include <QWidget>

#include "review/replay_presenter.h"

class QLabel;
class QPushButton;

namespace facenav::ui {

class ImageView;
class SceneView;

class ReplayPage : public QWidget {
  Q_OBJECT

 public:
  ReplayPage(ReplayPresenter& presenter, CaseModel& model, QWidget* parent = nullptr);

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  QWidget* makeControls();
  void addKeys();
  void showCase();
  void showTrack();
  void showTarget(const std::optional<guidance::Target>& target);
  void showMoment();
  void showPicture();

  ReplayPresenter& presenter_;
  CaseModel& model_;
  SceneView* scene_;
  ImageView *left_, *right_;
  QLabel *figures_, *time_;
  QPushButton *back_, *play_, *forward_, *pictures_, *overlay_;
  std::optional<guidance::Target> target_;  // the drawn target
  bool is_outdated_ = true;
};

}  // namespace facenav::ui
