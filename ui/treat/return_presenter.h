#pragma once
// ReturnPresenter: the interrupted session of the case (treat/session_return.h), as the Treat page offers it:
// continue it, or begin a new one. It looks when a case is opened and when a session ends.

#include <QObject>
#include <optional>

#include "treat/treat_presenter.h"

namespace facenav::ui {

class ReturnPresenter : public QObject {
  Q_OBJECT

 public:
  ReturnPresenter(TreatPresenter& treat, CaseModel& model, QObject* parent = nullptr);

  /// True while an interrupted session is offered: none runs, and the user did not choose a new one.
  bool isOffered() const { return offered_.has_value(); }
  /// "The session of 14:05 was cut off 12 min ago: 83 of 200 pulses are kept, target M1 hand L."; empty if
  /// none is offered.
  QString words() const;
  /// What is missing to continue: "open the cameras first (step 1)"; empty if nothing is.
  QString missing() const;
  void goOn();
  /// Stops offering the session, which stays unchanged.
  void beginNew();

 signals:
  void changed();

 private:
  void look();
  void follow();

  TreatPresenter& treat_;
  CaseModel& model_;
  std::optional<casefile::SessionSoFar> offered_;
  std::optional<int> planned_;
  bool was_running_ = false;
};

}  // namespace facenav::ui
