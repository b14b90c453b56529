#pragma once
// WorklistPresenter: the radiographer's list: cases of the cases folder and what is on its way there, in
// words; read anew, behind the window, whenever the folder changes.

#include <QDateTime>
#include <QFileSystemWatcher>
#include <QObject>
#include <QTimer>

#include "facenav/casefile/sign_off.h"
#include "presenters/prepare_queue.h"

namespace facenav::ui {

/// How a line asks for attention: disc, triangle, ring, cross.
enum class Mark { done, look, waiting, fault };

/// One line of the list.
struct WorklistRow {
  int job_id = 0;                // of the queue; 0: a case
  QString case_folder;           // empty for a job
  QString name;                  // the case's label or else its id, the job's title
  QString label;                 // empty: none
  bool can_be_labelled = false;  // a case that can be read
  QString state;                 // "checked"
  int state_order = 0;           // to sort by: what asks for something first
  Mark mark = Mark::done;
  QDateTime created;
  QString age;
  int findings = -1;  // -1: not known
  QString checked_by;
  QString detail;          // first finding, step and time, failure
  double fraction = -1.0;  // of the step that runs; < 0: none
};

/// "now", "12 min", "3 h", "2 days", "5 weeks".
QString ageInWords(const QDateTime& created, const QDateTime& now);

class WorklistPresenter : public QObject {
  Q_OBJECT

 public:
  explicit WorklistPresenter(PrepareQueue& queue, QObject* parent = nullptr);
  ~WorklistPresenter() override;

  QString folder() const { return folder_; }
  /// Remembered; made when it does not exist.
  void setFolder(const QString& folder);
  /// The remembered folder, else ~/FaceNav/cases.
  static QString rememberedFolder();
  void refresh();
  /// What people call the case; empty takes it away. refused() says why it could not be done.
  void setLabel(const QString& case_folder, const QString& words);

  const std::vector<WorklistRow>& rows() const { return rows_; }
  /// Why the folder cannot be read; empty while it can.
  QString problem() const { return problem_; }

 signals:
  void changed();
  void labelled(const QString& case_folder, const QString& label);
  void refused(const QString& words);

 private:
  void makeRows();
  void watch();

  PrepareQueue& queue_;
  TaskRunner reader_;
  QFileSystemWatcher watcher_;
  QTimer soon_, age_;
  QString folder_, problem_;
  std::vector<casefile::WorklistEntry> entries_;
  std::vector<WorklistRow> rows_;
  bool is_outdated_ = false;
};

}  // namespace facenav::ui
