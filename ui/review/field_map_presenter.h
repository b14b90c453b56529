#pragma once
// FieldMapPresenter: which spot of the cortex explains the MEPs of the chosen session, by the field of each
// pulse (treat/mep_by_field.h), for Review. Computed on a worker thread while it is wanted; a changed session
// takes the old map away at once. The coil is that of Plan's field.

#include <QObject>
#include <optional>

#include "facenav/treat/mep_by_field.h"
#include "review/review_presenter.h"

namespace facenav::ui {

class FieldMapPresenter : public QObject {
  Q_OBJECT

 public:
  FieldMapPresenter(ReviewPresenter& review, CaseModel& model, QObject* parent = nullptr);

  bool isOn() const { return is_on_; }
  void setOn(bool is_on);

  /// What is drawn on the brain of ReviewPresenter::session().
  struct Shown {
    std::shared_ptr<const ReviewedSession> session;
    steps::MepByField map;
    std::vector<float> r2;  // at the vertices of the session's brain; no number: not regressed
    std::string coil;
  };
  /// Null until it is computed, and while it is off or nothing can be told.
  const Shown* shown() const { return shown_.get(); }
  /// The findings, or why there are none; empty while it is off.
  QString words() const;

 signals:
  void changed();

 private:
  void follow();
  void compute();

  ReviewPresenter& review_;
  CaseModel& model_;
  TaskRunner runner_;
  bool is_on_ = false;
  std::shared_ptr<const ReviewedSession> wanted_;
  std::shared_ptr<const Shown> shown_;
  QString failure_;
};

}  // namespace facenav::ui
