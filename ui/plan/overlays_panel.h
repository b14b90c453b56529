#pragma once
// OverlaysPanel: the list of a case's overlays, with add, remove, opacity and, for maps, threshold and end of
// the colours.

#include <QFrame>

#include "plan/overlay_presenter.h"

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;
class QSlider;

namespace facenav::ui {

class OverlaysPanel : public QFrame {
  Q_OBJECT

 public:
  explicit OverlaysPanel(OverlayPresenter& presenter, QWidget* parent = nullptr);

 signals:
  /// The user wants to choose a file; a menu that contains this panel closes.
  void choosing();

 private:
  void makeFields();
  void choose();
  void showEntries();
  void showChosen();
  void changeChosen();

  OverlayPresenter& presenter_;
  QListWidget* list_;
  QLabel* words_;
  QPushButton *add_, *remove_;
  QComboBox* space_;
  QSlider* opacity_;
  QDoubleSpinBox *threshold_, *full_;
  QLineEdit* unit_;
  bool is_filling_ = false;
};

}  // namespace facenav::ui
