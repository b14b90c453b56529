#pragma once
// ImportPresenter: takes targets and pulses of other programs' files into the open case
// (plan/import_other.h). Files are read on a worker thread, again after each answer; nothing is written
// before bringIn(). The new targets are one step of the plan; pulses become sessions.

#include <QObject>

#include "facenav/plan/import_other.h"
#include "plan/plan_presenter.h"
#include "shell/task_runner.h"

namespace facenav::ui {

class ImportPresenter : public QObject {
  Q_OBJECT

 public:
  ImportPresenter(CaseModel& model, PlanPresenter& plan, QObject* parent = nullptr);

  /// Reads these files; changed() follows. Valid only while a case is open.
  void open(const QStringList& files);
  /// The files as they were last read, in their order.
  const std::vector<steps::PreviewedFile>& files() const { return files_; }
  bool isReading() const { return reader_.isRunning() || is_outdated_; }
  /// The answers for a file, as last given.
  const steps::OtherImport& order(std::size_t file) const { return orders_.at(file); }
  /// Changes the answers for a file, and reads again.
  void setOrder(std::size_t file, const steps::OtherImport& order);
  /// Takes a target, or a session's pulses, in or leaves it out. Only those that may come in change.
  void setTargetTaken(std::size_t file, const std::string& target, bool is_taken);
  void setSessionTaken(std::size_t file, const std::string& session, bool is_taken);
  /// Takes all in that may come in, or leaves all out.
  void takeAll(bool are_taken);
  /// Numbers of targets and of pulses that would come in now.
  int targets() const;
  int pulses() const;
  /// "2 targets and 12 pulses come in; 1 is refused".
  QString summary() const;
  /// The case's T1; null before the files were read.
  const interop::T1* t1() const { return head_ ? &head_->t1 : nullptr; }
  /// True if sform and qform of the case's T1 differ, or did before it was prepared, or another T1 is named.
  bool hasTwoForms(std::size_t file) const;
  /// Writes what would come in. broughtIn() tells what came; refused() why nothing did.
  void bringIn();

 signals:
  void changed();
  void refused(const QString& words);
  /// `session`: name of the last new session; empty: there is none.
  void broughtIn(const QString& words, bool has_targets, const QString& session);

 private:
  void read();
  void goOn();
  int count(steps::ItemFate fate) const;

  CaseModel& model_;
  PlanPresenter& plan_;
  TaskRunner reader_;
  std::vector<steps::OtherImport> orders_;  // as wanted; `files_` follows
  std::vector<steps::PreviewedFile> files_;
  std::shared_ptr<const interop::CaseHead> head_;
  bool is_outdated_ = false, is_writing_ = false;
};

}  // namespace facenav::ui
