#pragma once
// SignOffPresenter: the page on which a named person signs off the open case's model: volumes with the normal
// range, a tick for every finding, name and note. Signing needs every tick, and covers only what was shown.

#include <QObject>

#include <functional>

#include "shell/case_model.h"
#include "shell/task_runner.h"

namespace facenav::ui {

struct VolumeLine {
  QString words;  // "brain 1 412 ml (correction, not saved), inside the normal range .."
  bool is_normal = true;
};

class SignOffPresenter : public QObject {
  Q_OBJECT

 public:
  SignOffPresenter(CaseModel& model, TaskRunner& tasks, QObject* parent = nullptr);

  /// Items to tick: the outlines on the montage, then each finding verbatim.
  const QStringList& items() const { return items_; }
  void setSeen(int item, bool is_seen);
  QString name() const { return name_; }
  /// Name or initials; remembered.
  void setName(const QString& name);
  /// Note of the sign-off; the reason if the scan is not usable or is rejected.
  void setNote(const QString& note);
  std::vector<VolumeLine> volumes() const;
  bool canSign() const;
  /// Why it cannot be signed yet, in words; empty if it can.
  QString whatIsMissing() const;
  void sign();
  /// Rejects the scan for the reason given as note. Needs a name and a reason.
  bool canReject() const;
  void reject();
  /// True if the import check calls the scan not usable: signing it needs a reason.
  bool isNotUsable() const { return is_not_usable_; }
  /// What to ask the scanner's staff for, by the import check; empty if nothing.
  QString whatToAskFor() const { return asks_.join("; "); }
  /// "checked 20 Nov by XY", "not signed off", "void: brain_mask.nii.gz changed since XY checked it".
  QString statusWords() const;
  bool isVoid() const;
  bool holds() const;

 signals:
  void changed();

 private:
  CaseModel& model_;
  TaskRunner& tasks_;
  QStringList items_;
  std::vector<bool> seen_;
  QString name_, note_;
  QStringList asks_;
  bool is_not_usable_ = false;

  void readCheck();
  void start(const QString& title, std::function<void(const casefile::CaseStore&)> write);
};

}  // namespace facenav::ui
