#pragma once
// PlacePanel: coordinates and labels of the crosshair, and a field to type coordinates into.

#include <QFrame>

#include "plan/place_presenter.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace facenav::ui {

class PlacePanel : public QFrame {
  Q_OBJECT

 public:
  explicit PlacePanel(PlacePresenter& presenter, QWidget* parent = nullptr);
  void show(const Point<Mri>& crosshair);
  /// Moves the keyboard focus to the field.
  void takeFocus();

 signals:
  /// Coordinates were typed: move the crosshair there.
  void goTo(double x_mm, double y_mm, double z_mm);
  /// The user wants a target at the crosshair.
  void targetWanted(double x_mm, double y_mm, double z_mm);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  /// Makes room for the longest word: an atlas' label cannot be broken.
  void leaveRoom();
  void read();

  PlacePresenter& presenter_;
  Point<Mri> crosshair_;
  QLabel *words_, *fault_;
  QComboBox* frame_;
  QLineEdit* typed_;
  QPushButton* target_;
};

}  // namespace facenav::ui
