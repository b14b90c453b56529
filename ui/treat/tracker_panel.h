#pragma once
// TrackerPanel: step 1 of Treat for a session without cameras: the other tracker, the names of its poses, its
// alignment (a file, or landmarks touched with its pointer), and what it sends.

#include <QFrame>
#include <QTimer>

#include "treat/treat_presenter.h"

class QDoubleSpinBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QVBoxLayout;

namespace facenav::ui {

class TrackerPanel : public QFrame {
  Q_OBJECT

 public:
  explicit TrackerPanel(TreatPresenter& treat, QWidget* parent = nullptr);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  QLineEdit* addLine(QVBoxLayout& column, const QString& name, const QString& example, const QString& tip);
  void addAlignment(QVBoxLayout& column);
  void addTouching(QVBoxLayout& column);
  void take();
  void fillLandmarks();
  void showState();

  TreatPresenter& treat_;
  TrackerPresenter& tracker_;
  QLineEdit *coil_, *head_, *second_, *alignment_, *pointer_;
  QLabel* state_;
  QPushButton *use_, *by_points_;
  QDoubleSpinBox* error_;
  QVBoxLayout* touches_;
  QList<QPushButton*> landmarks_;
  QTimer timer_;
};

}  // namespace facenav::ui
