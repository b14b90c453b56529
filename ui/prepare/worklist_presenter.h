#pragma once
// WorklistPresenter: the radiographer's list in words: cases of the cases folder, and jobs that will become
// cases. It is read again in the background whenever the folder changes.

#include <QDateTime>
#include <QFileSystemWatcher>
#include <QObject>
#include <QTimer>

#include "facenav/casefile/sign_off.h"
#include "prepare/prepare_queue.h"

namespace facenav::ui {

/// How a line shows its state: disc, triangle, ring, cross.
enum class Mark { done, look, waiting, fault };

/// One line of the list.
struct WorklistRow {
  int job_id = 0;                // job in the queue; 0: a case
  QString case_folder;           // empty for a job
  QString name;                  // the case's label or id, or the job's title
  QString label;                 // empty: none
  bool can_be_labelled = false;  // true for a readable case
  QString state;                 // "checked"
  int state_order = 0;           // to sort by: lines that need attention first
  Mark mark = Mark::done;
  QDateTime created;
  QString age;
  int findings = -1;  // -1: unknown
  QString checked_by;
  QString detail;          // first finding; step and time; or failure
  double fraction = -1.0;  // of the running step; < 0 if none runs
};

/// "now", "12 min", "3 h", "2 days", "5 weeks".
QString ageInWords(const QDateTime& created, const QDateTime& now);

class WorklistPresenter : public QObject {
  Q_OBJECT

 public:
  explicit WorklistPresenter(PrepareQueue& queue, QObject* parent = nullptr);
  ~WorklistPresenter() override;

  QString folder() const { return folder_; }
  /// Sets the folder and remembers it; created if it does not exist.
  void setFolder(const QString& folder);
  /// The remembered folder, else ~/FaceNav/cases.
  static QString rememberedFolder();
  void refresh();
  /// Sets the case's label; empty removes it. refused() says why it failed.
  void setLabel(const QString& case_folder, const QString& words);
  /// The case that the window works on; it cannot be deleted.
  void setOpenCase(const QString& case_folder) { open_case_ = case_folder; }
  /// Moves a case of the list to the desktop's trash. Returns its new place; empty, after refused(), if that
  /// failed.
  QString moveToTrash(const QString& case_folder);

  const std::vector<WorklistRow>& rows() const { return rows_; }
  /// Why the folder cannot be read; empty if it can.
  QString problem() const { return problem_; }

 signals:
  void changed();
  void labelled(const QString& case_folder, const QString& label);
  void refused(const QString& words);
  void said(const QString& words);

 private:
  void makeRows();
  void watch();

  PrepareQueue& queue_;
  TaskRunner reader_;
  QFileSystemWatcher watcher_;
  QTimer soon_, age_;
  QString folder_, problem_, open_case_;
  std::vector<casefile::WorklistEntry> entries_;
  std::vector<WorklistRow> rows_;
  bool is_outdated_ = false;
};

}  // namespace facenav::ui
