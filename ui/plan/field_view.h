#pragma once
// FieldView: what Plan says of the electric field while it is on: the colour bar, the numbers, and the search
// for the best angle and place.

#include <QFrame>

#include "plan/best_pose_presenter.h"

class QComboBox;
class QLabel;
class QPushButton;

namespace facenav::ui {

class ColourLegend;

class FieldView : public QFrame {
  Q_OBJECT

 public:
  FieldView(FieldPresenter& field, BestPosePresenter& best, QWidget* parent = nullptr);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void fitLabels();
  void showField();
  void showAgainst();
  void showBest();

  FieldPresenter& field_;
  BestPosePresenter& best_;
  ColourLegend* bar_;
  QLabel *words_, *against_, *proposal_;
  QComboBox* aim_;
  QPushButton *search_, *take_;
};

}  // namespace facenav::ui
