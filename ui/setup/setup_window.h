#pragma once
// SetupWindow: `facenav-gui --set-up`: places, calibrates and checks two cameras, and the coil's marker, in
// four steps. Each has both live pictures, one sentence and few buttons. Return continues.

#include <QTimer>
#include <QWidget>

#include "setup/setup_presenter.h"

class QLabel;
class QProgressBar;
class QPushButton;
class QVBoxLayout;

namespace facenav::ui {

class FittedWords;
class ImageView;
class SetupTools;

class SetupWindow : public QWidget {
  Q_OBJECT

 public:
  explicit SetupWindow(const Services& services, QWidget* parent = nullptr);
  ~SetupWindow() override;

  SetupPresenter& presenter() { return presenter_; }
  /// Opens a kept pair as soon as the search for cameras has ended.
  void openKept(const QString& rig);

 signals:
  /// A pair was saved under this name.
  void kept(const QString& name);

 protected:
  void closeEvent(QCloseEvent* event) override;

 private:
  void makeSteps(QVBoxLayout& column);
  void makeMiddle(QVBoxLayout& column);
  void makeBottom(QVBoxLayout& column);
  void goOn();
  void goBack();
  void refresh();
  void showSteps();
  void showLines(const steps::SetupView& view);

  Services services_;
  TaskRunner tasks_;
  SetupPresenter presenter_;
  QPushButton* steps_[4];
  ImageView *left_, *right_;
  FittedWords* sentence_;
  QLabel* lines_;
  QProgressBar* progress_;
  SetupTools* tools_;
  QPushButton *back_, *next_;
  QTimer timer_;
  QString to_open_;  // name of a kept pair
  QString trouble_;  // last refusal; empty if there was none
  std::shared_ptr<const steps::SetupView> shown_;
};

}  // namespace facenav::ui
