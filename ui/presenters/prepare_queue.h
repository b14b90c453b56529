#pragma once
// PrepareQueue: dropped folders and NIfTI files on their way to becoming cases: scanned, the recommended
// series prepared, one at a time, behind the rest of the window and at low priority. What cannot be done
// stays in the list with its one line and can be tried again; what waits is taken up again after a restart.

#include <QElapsedTimer>
#include <QObject>
#include <deque>
#include <memory>

#include "presenters/services.h"
#include "presenters/task_runner.h"

class QLockFile;

namespace facenav::ui {

enum class JobState { queued, preparing, needs_choice, failed, cancelled };

struct PrepareJob {
  int id = 0;
  QString input;                          // folder or file
  std::optional<std::string> series_uid;  // nothing: the recommended one
  JobState state = JobState::queued;
  QString title;  // the series' description once scanned; before, its number and when it was queued
  QString step;   // what is done now, in words
  double fraction = 0.0;
  QString failure;
  int patients = 0;  // whose images were found, where a choice is needed
  int readings = 0;  // ways to read the same slices, where a choice is needed
};

class PrepareQueue : public QObject {
  Q_OBJECT

 public:
  explicit PrepareQueue(const Services& services, QObject* parent = nullptr);
  /// Cancels what runs; it is taken up again at the next start.
  ~PrepareQueue() override;

  /// Where cases are made; nothing is begun before this is known.
  void setCasesFolder(const QString& folder);
  /// Returns the job's id; an input that waits or runs already with the same series is not queued twice.
  int add(const QString& input, const std::optional<std::string>& series_uid = std::nullopt);
  void cancel(int id);
  void retry(int id);
  /// Takes a job that does not run out of the list.
  void remove(int id);
  /// New cases are labelled with the patient's name (remembered; off at first).
  bool labelsByPatient() const;
  void setLabelsByPatient(bool is_labelled);
  /// True: nothing new is begun (a treatment runs); the running one goes on.
  void setHeld(bool is_held);
  /// Queues what was unfinished when the program ended; removes what was fetched for jobs that are no more.
  /// Nothing of this beside another window of this user: it is that one's.
  void restore();

  const std::deque<PrepareJob>& jobs() const { return jobs_; }
  const PrepareJob* job(int id) const;
  bool isRunning() const { return tasks_.isRunning(); }
  /// "22 s, about 14 s left"; empty while nothing runs.
  QString timeWords() const;
  /// "preparing 1, 2 waiting"; empty when there is nothing to do.
  QString summary() const;

 signals:
  /// A job came, went or changed its state.
  void changed();
  /// Step, fraction or time of the running job.
  void progressed();
  void prepared(const QString& case_folder, const QString& case_id);
  /// No series of this input is recommended, or it is of several patients or readings: one must be chosen by
  /// hand.
  void choiceNeeded(int id);

 private:
  PrepareJob* find(int id);
  void begin();
  void end(JobState state, const QString& failure);
  void store() const;
  void forgetReceived(const QString& input);

  const Services& services_;
  TaskRunner tasks_;
  std::deque<PrepareJob> jobs_;
  QString cases_folder_;
  QElapsedTimer elapsed_;
  std::unique_ptr<QLockFile> only_window_;
  int last_id_ = 0, running_ = 0;
  bool is_held_ = false;
};

/// Private to the user: what came from the archive, one folder a series; removed when its job is.
QString receivedFolder();
/// NIfTI by its name.
bool isNifti(const QString& path);
/// The folder of a DICOM file; a folder or a NIfTI file as it is, of a pair the .hdr.
QString inputOf(const QString& dropped_path);
/// Why somebody must choose: "images of 2 patients", "slices that can be read in several
/// ways", "no series is recommended".
QString choiceWords(const PrepareJob& job);
/// The series that an unattended preparation takes, or null: one must be chosen.
const dicom::SeriesInfo* recommendedOf(const std::vector<dicom::SeriesInfo>& series);

}  // namespace facenav::ui
