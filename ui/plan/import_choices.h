#pragma once
// ImportChoices: what a file of another program leaves open: its space, the form and the T1 that it means,
// its handle, its frame between the ears, equal names, its clock.

#include <QFrame>

#include "plan/import_presenter.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QGridLayout;
class QLabel;
class QPushButton;

namespace facenav::ui {

class ElidedLabel;

class ImportChoices : public QFrame {
  Q_OBJECT

 public:
  explicit ImportChoices(ImportPresenter& presenter, QWidget* parent = nullptr);
  /// Shows the answers for this file; -1: for none.
  void showFile(int file);

 private:
  void makeT1(QGridLayout& grid, int row);
  void connectAnswers();
  void answer(const std::function<void(steps::OtherImport&)>& change);
  void showAnswers();

  ImportPresenter& presenter_;
  int file_ = -1;
  QLabel *heading_, *clock_words_;
  QComboBox *space_, *form_, *handle_, *frame_;
  ElidedLabel* t1_;
  QPushButton *choose_t1_, *own_t1_;
  QCheckBox* replaces_;
  QDoubleSpinBox* clock_;
  bool is_showing_ = false;
};

}  // namespace facenav::ui
