#pragma once
// ExportWindow: writes targets and pulses of the open case for another program: format, targets, session,
// where to. It says what was written, and does not hold up the window that it belongs to.

#include <QWidget>

#include "plan/export_presenter.h"

class QCheckBox;
class QComboBox;
class QGridLayout;
class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;

namespace facenav::ui {

class ExportWindow : public QWidget {
  Q_OBJECT

 public:
  /// `session`: the session to begin with; empty: none.
  ExportWindow(CaseModel& model, const QString& session, QWidget* parent);

 signals:
  /// What was written, in one line.
  void written(const QString& words);

 private:
  void makeFields(QGridLayout& grid);
  void makeFile(QGridLayout& grid);
  void fill(const QString& session);
  const interop::Format& format() const;
  steps::OtherExport order() const;
  void showFormat();
  void chooseFile();
  void write();
  void say(const QString& words, bool is_fault);

  ExportPresenter presenter_;
  QComboBox *formats_, *pulses_;
  QListWidget* targets_;
  QLineEdit* file_;
  QCheckBox* replaces_;
  QLabel* words_;
  QPushButton* write_;
  bool is_file_chosen_ = false;  // by the user; else it follows the format
};

}  // namespace facenav::ui
