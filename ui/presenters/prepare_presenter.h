#pragma once
// PreparePresenter: what the Prepare workspace does: scan a folder for series, prepare one into a case, show
// findings.

#include <QObject>

#include "presenters/case_model.h"
#include "presenters/services.h"
#include "presenters/task_runner.h"

namespace facenav::ui {

/// One line of the series list, in words.
struct SeriesLine {
  QString title, detail;
  bool is_usable = false, is_recommended = false;
};
/// A finding of the preparation: fine, or something to look at.
struct FindingLine {
  QString words;
  bool is_caution = false;
};

class PreparePresenter : public QObject {
  Q_OBJECT

 public:
  PreparePresenter(const Services& services, CaseModel& model, TaskRunner& tasks, QObject* parent = nullptr);

  /// DICOM folder: lists its series. NIfTI file: one line.
  void openInput(const QString& path);
  /// The chosen line -> case folder; the case is opened when done.
  void prepare(int line, const QString& case_folder);
  void openCase(const QString& folder);

  const std::vector<SeriesLine>& lines() const { return lines_; }
  /// The line to choose first; -1: none can be used.
  int recommendedLine() const;
  std::vector<FindingLine> findings() const;

 signals:
  void linesChanged();

 private:
  void setSeries(const QString& input, const std::vector<dicom::SeriesInfo>& series);

  const Services& services_;
  CaseModel& model_;
  TaskRunner& tasks_;
  QString input_;
  std::vector<dicom::SeriesInfo> series_;
  std::vector<SeriesLine> lines_;
};

}  // namespace facenav::ui
