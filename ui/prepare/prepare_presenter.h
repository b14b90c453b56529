#pragma once
// PreparePresenter: lists a folder's series, of which one is chosen by hand and queued; opens a case; shows
// its findings.

#include <QObject>

#include "prepare/prepare_queue.h"
#include "shell/case_model.h"

namespace facenav::ui {

/// One line of the series list, in words.
struct SeriesLine {
  QString title, detail;
  QString patient;  // "patient 2" if there are several; the name if it is to be shown; else empty
  bool is_usable = false, is_recommended = false;
  std::optional<dicom::Thumbnail> thumbnail;
};
/// A finding of the preparation: fine, or something to look at.
struct FindingLine {
  QString words;
  bool is_caution = false;
  std::optional<Point<Mri>> place = {};  // of the head that it speaks of
};

class PreparePresenter : public QObject {
  Q_OBJECT

 public:
  PreparePresenter(const Services& services, CaseModel& model, TaskRunner& tasks, PrepareQueue& queue,
                   QObject* parent = nullptr);

  /// Lists the series of a DICOM folder; a NIfTI file gives one line.
  void openInput(const QString& path);
  /// Queues the chosen line.
  void prepare(int line);
  void openCase(const QString& folder);

  const std::vector<SeriesLine>& lines() const { return lines_; }
  /// The line to choose first; -1 if none is usable, or if the user must choose between patients, or between
  /// readings of the same slices.
  int recommendedLine() const;
  /// Names are hidden until the user asks for them.
  void setPatientsShown(bool are_shown);
  QString input() const { return input_; }
  std::vector<FindingLine> findings() const;

 signals:
  void linesChanged();

 private:
  /// A listed series.
  struct Listed {
    dicom::SeriesInfo info;
    std::optional<dicom::Thumbnail> thumbnail;
    QString patient;  // description in words
  };
  void makeLines();

  const Services& services_;
  CaseModel& model_;
  TaskRunner& tasks_;
  PrepareQueue& queue_;
  QString input_;
  std::vector<Listed> series_;
  bool are_patients_shown_ = false, has_several_patients_ = false, has_several_readings_ = false;
  std::vector<SeriesLine> lines_;
};

}  // namespace facenav::ui
