#pragma once
// PrepareQueue: queue of dropped folders and NIfTI files to convert to cases. Each is scanned and its
// recommended series prepared, one at a time, in the background and at low priority. A failed job stays in
// the list with one line of explanation and can be retried. Waiting jobs continue after a restart.

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <deque>
#include <memory>

#include "prepare/field_queue.h"
#include "shell/services.h"
#include "shell/task_runner.h"

class QLockFile;

namespace facenav::ui {

enum class JobState { queued, preparing, needs_choice, failed, cancelled };

struct PrepareJob {
  int id = 0;
  QString input;                          // folder or file
  std::optional<std::string> series_uid;  // absent: the recommended one
  JobState state = JobState::queued;
  QString title;  // the series' description once scanned; before that, the job's number and time
  QString step;   // current step, in words
  double fraction = 0.0;
  QString failure;
  int patients = 0;  // number of patients found, if a choice is needed
  int readings = 0;  // ways to read the same slices, if a choice is needed
};

class PrepareQueue : public QObject {
  Q_OBJECT

 public:
  explicit PrepareQueue(const Services& services, QObject* parent = nullptr);
  /// Cancels the running job; it starts again with the next program start.
  ~PrepareQueue() override;

  /// Sets the folder for new cases. No job starts before this is set.
  void setCasesFolder(const QString& folder);
  /// Returns the job's id. An input that waits or runs with the same series is not queued twice.
  int add(const QString& input, const std::optional<std::string>& series_uid = std::nullopt);
  void cancel(int id);
  void retry(int id);
  /// Removes a job that is not running.
  void remove(int id);
  /// True if new cases are labelled with the patient's name (remembered; off at first).
  bool labelsByPatient() const;
  void setLabelsByPatient(bool is_labelled);
  /// Holds the queue during a treatment: no job starts; a running job continues.
  void setHeld(bool is_held);
  /// Builds the electric field's model of a case again in the background (FieldQueue).
  void buildField(const QString& case_folder) { fields_.add(case_folder); }
  /// Queues the jobs that were unfinished when the program ended, and removes fetched files of jobs that no
  /// longer exist. Does nothing while another window of this user is open, since they may be that window's
  /// jobs.
  void restore();

  const std::deque<PrepareJob>& jobs() const { return jobs_; }
  const PrepareJob* job(int id) const;
  bool isRunning() const { return tasks_.isRunning(); }
  /// Share of the running job that is done, judged by the last job's duration; never falls, 1 only at its
  /// end.
  double doneShare() const;
  /// "22 s, about 14 s left"; empty if no job runs.
  QString timeWords() const;
  /// "preparing 1, 2 waiting"; empty if there is no job.
  QString summary() const;

 signals:
  /// A job was added, removed or changed its state.
  void changed();
  /// Step, fraction or time of the running job changed.
  void progressed();
  void prepared(const QString& case_folder, const QString& case_id);
  /// As FieldQueue::ended.
  void fieldEnded(const QString& case_folder, const QString& failure);
  /// The user must choose: no series of this input is recommended, or it has several patients or readings.
  void choiceNeeded(int id);

 private:
  PrepareJob* find(int id);
  void begin();
  void end(JobState state, const QString& failure);
  void store() const;
  void forgetReceived(const QString& input);

  const Services& services_;
  TaskRunner tasks_;
  FieldQueue fields_;
  std::deque<PrepareJob> jobs_;
  QString cases_folder_;
  QElapsedTimer elapsed_;
  QTimer tick_;  // the share moves between the work's own reports, too
  std::unique_ptr<QLockFile> only_window_;
  int last_id_ = 0, running_ = 0;
  bool is_held_ = false;
};

/// Folder for files fetched from the archive, private to the user. One subfolder a series, removed with its
/// job.
QString receivedFolder();
/// True if the file name is that of a NIfTI file.
bool isNifti(const QString& path);
/// The input for a dropped path: the folder of a DICOM file; a folder or NIfTI file itself; the .hdr of a
/// pair.
QString inputOf(const QString& dropped_path);
/// Why the user must choose: "images of 2 patients", "slices that can be read in several ways", "no series is
/// recommended".
QString choiceWords(const PrepareJob& job);
/// The series to prepare without asking, or null if one must be chosen.
const dicom::SeriesInfo* recommendedOf(const std::vector<dicom::SeriesInfo>& series);

}  // namespace facenav::ui
