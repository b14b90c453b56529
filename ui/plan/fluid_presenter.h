#pragma once
// FluidPresenter: builds the electric field's model with the fluid round the brain (tier 2) when a person
// asks for it, in the background, with progress and cancel. The case then keeps the model.

#include <QObject>

#include "shell/case_model.h"
#include "shell/task_runner.h"

namespace facenav::ui {

class FluidPresenter : public QObject {
  Q_OBJECT

 public:
  explicit FluidPresenter(CaseModel& model, QObject* parent = nullptr);
  ~FluidPresenter() override;

  /// True if the case can have the model and does not.
  bool isPossible() const { return can_have_ && !is_present_; }
  bool isBuilding() const { return runner_.isRunning(); }
  /// Begins to build it; nothing if it is not possible or under way.
  void build();
  void cancel() { runner_.cancel(); }
  /// "with the fluid (takes about 60 s)", "solving 40 %: stop", "with the fluid: built"
  QString words() const;
  /// Why the last attempt failed; or empty.
  QString failure() const { return failure_; }

 signals:
  void changed();
  /// The open case has the model now.
  void built();
  /// failure() says why.
  void failed();

 private:
  void follow();

  CaseModel& model_;
  TaskRunner runner_;
  bool can_have_ = false, is_present_ = false;
  QString progress_, failure_;
  int subject_ = 0;  // number of the case or brain that is open
};

}  // namespace facenav::ui
