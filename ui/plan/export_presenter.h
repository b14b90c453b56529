#pragma once
// ExportPresenter: writes targets and pulses of the open case as a file for another program
// (plan/export_other.h), or plan and report as DICOM for the archive (plan/export_dicom.h), where they name
// the patient. DICOM is written on a worker thread.

#include <QObject>

#include "facenav/plan/export_dicom.h"
#include "facenav/plan/export_other.h"
#include "shell/case_model.h"
#include "shell/services.h"
#include "shell/task_runner.h"

namespace facenav::ui {

/// What can be written for the archive.
enum class DicomKind { series, segments, report };

struct DicomWish {
  DicomKind kind = DicomKind::series;
  steps::DicomExport order;
  QString session = {};  // of a report
  bool is_sent = false;  // to the archive, after it is written
};

class ExportPresenter : public QObject {
  Q_OBJECT

 public:
  using SendToArchive = decltype(Services::storeInArchive);

  explicit ExportPresenter(CaseModel& model, SendToArchive send = nullptr, QObject* parent = nullptr);

  /// The formats that are written for other programs.
  const std::vector<const interop::Format*>& formats() const;
  /// Names of the case's targets, and of its sessions, newest first.
  QStringList targets() const;
  QStringList sessions() const;
  /// The format's usual file in the user's folder of documents. It never has the patient's name.
  QString usualFile(const interop::Format& format) const;
  QString usualFile(DicomKind kind) const;
  /// Writes the file. Returns what was written, one line each; empty after refused().
  QString write(const steps::OtherExport& order);
  /// Begins to write DICOM; written() or refused() follows.
  void writeDicom(const DicomWish& wish);
  bool isWriting() const { return runner_.isRunning(); }
  void cancel() { runner_.cancel(); }
  /// "ARCHIVE at pacs.example"; empty if no archive is set up.
  QString archiveWords() const;

 signals:
  void refused(const QString& words);
  /// Says each thing that was done in a line of its own.
  void written(const QString& words);
  void progressed(const QString& words);

 private:
  CaseModel& model_;
  SendToArchive send_;
  TaskRunner runner_;
};

}  // namespace facenav::ui
