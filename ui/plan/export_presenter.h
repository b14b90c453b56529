#pragma once
// ExportPresenter: writes targets and pulses of the open case as a file for another program
// (plan/export_other.h).

#include <QObject>

#include "facenav/plan/export_other.h"
#include "shell/case_model.h"

namespace facenav::ui {

class ExportPresenter : public QObject {
  Q_OBJECT

 public:
  explicit ExportPresenter(CaseModel& model, QObject* parent = nullptr) : QObject(parent), model_(model) {}

  /// The formats that are written.
  const std::vector<const interop::Format*>& formats() const;
  /// Names of the case's targets, and of its sessions, newest first.
  QStringList targets() const;
  QStringList sessions() const;
  /// The format's usual file in the user's folder of documents. It never has the patient's name.
  QString usualFile(const interop::Format& format) const;
  /// Writes the file. Returns what was written, one line each; empty after refused().
  QString write(const steps::OtherExport& order);

 signals:
  void refused(const QString& words);

 private:
  CaseModel& model_;
};

}  // namespace facenav::ui
