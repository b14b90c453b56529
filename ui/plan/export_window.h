#pragma once
// ExportWindow: writes targets and pulses of the open case for another program, or plan and report as DICOM
// for the archive: format, targets, session, where to. It says what was written, and does not hold up the
// window that it belongs to.

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
  /// `session`: the session to begin with; empty: none. `send`: sends files to the archive.
  ExportWindow(CaseModel& model, const QString& session, ExportPresenter::SendToArchive send,
               QWidget* parent);

 signals:
  /// What was written, in one line.
  void written(const QString& words);

 private:
  void connectPresenter(CaseModel& model);
  void makeFields(QGridLayout& grid);
  void makeSource(QGridLayout& grid);
  void makeFile(QGridLayout& grid);
  QWidget* makeButtons();
  void fill(const QString& session);
  /// The chosen kind of DICOM; nothing for a format of another program.
  std::optional<DicomKind> dicom() const;
  const interop::Format& format() const;
  steps::OtherExport order() const;
  std::vector<std::string> ticked() const;
  void showFormat();
  void showDicom(DicomKind kind);
  void chooseFile();
  void chooseSource();
  void write();
  void writeDicom(DicomKind kind);
  void tell(const QString& words);
  void say(const QString& words, bool is_fault);

  ExportPresenter presenter_;
  QComboBox *formats_, *pulses_;
  QListWidget* targets_;
  QLineEdit *source_, *file_;
  QCheckBox *replaces_, *sends_;
  QLabel *words_, *source_label_;
  QPushButton *choose_source_, *write_, *close_;
  bool is_file_chosen_ = false;  // by the user; else it follows the format
};

}  // namespace facenav::ui
