#pragma once
// CamerasPanel: step 1 of Treat, beside the live images: the two cameras, their calibration, and the two
// still images for the alignment; or a recording.

#include <QFrame>
#include <QTimer>

#include "treat/treat_presenter.h"

class QComboBox;
class QGridLayout;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace facenav::ui {

class CamerasPanel : public QFrame {
  Q_OBJECT

 public:
  explicit CamerasPanel(TreatPresenter& presenter, QWidget* parent = nullptr);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void addChoice(QVBoxLayout& column);
  void addNamedRig(QGridLayout& grid);
  void addSetUp(QVBoxLayout& column);
  void addCapture(QVBoxLayout& column);
  void fillDevices();
  void fillRigs();
  void showState();
  void chooseRig();
  void chooseRecording();
  QPushButton* button(const QString& text, const QString& tip, const QKeySequence& key);

  TreatPresenter& presenter_;
  CamerasPresenter& cameras_;
  QComboBox *left_, *right_, *named_rig_;
  QLabel *rig_, *state_, *capture_words_, *coil_words_;
  QPushButton *open_, *set_up_, *latency_, *marked_, *dots_, *plain_;
  QTimer timer_;
  int brings_ = 0;  // how many more times the picture button is scrolled into view
  bool is_filling_ = false;
};

}  // namespace facenav::ui
