#pragma once
// FieldImportWindow: shows what an electric field of another program would give to a target, before it is
// taken into the case: the target, the rate of the current, what was found. It does not hold up the window
// that it belongs to.

#include <QWidget>

#include "plan/field_import_presenter.h"

class QComboBox;
class QDoubleSpinBox;
class QGridLayout;
class QLabel;
class QLineEdit;
class QPushButton;

namespace facenav::ui {

class FieldImportWindow : public QWidget {
  Q_OBJECT

 public:
  /// `may_be_scan`: the file may be a scan as well, and the user may say so.
  FieldImportWindow(CaseModel& model, PlanPresenter& plan, bool may_be_scan, QWidget* parent);
  void open(const QString& file, const QString& surface);
  FieldImportPresenter& presenter() { return presenter_; }

 signals:
  void takenIn(const QString& words);
  /// The user says that the file is a scan.
  void scanMeant(const QString& file);

 private:
  void makeAnswers(QGridLayout& grid);
  QLineEdit* addFile(QGridLayout& grid, int row, const QString& name, const QString& tip,
                     const QString& kinds, void (FieldImportPresenter::*set)(const QString&));
  QWidget* makeButtons(bool may_be_scan);
  void showState();

  FieldImportPresenter presenter_;
  QComboBox* target_;
  QDoubleSpinBox* rate_;
  QLineEdit *surface_, *t1_;
  QLabel *file_, *words_;
  QPushButton* take_in_;
};

}  // namespace facenav::ui
