#pragma once
// BestPosePresenter: searches the coil's best angle and place for the active target in the background and
// proposes it (plan/best_pose.h). The target changes only when a person takes the proposal; undo takes it
// back.

#include "plan/field_presenter.h"

namespace facenav::ui {

class BestPosePresenter : public QObject {
  Q_OBJECT

 public:
  BestPosePresenter(FieldPresenter& field, PlanPresenter& plan, CaseModel& model, QObject* parent = nullptr);

  /// What the best pose gives most of; remembered (QSettings).
  steps::FieldAim aim() const { return aim_; }
  void setAim(steps::FieldAim aim);
  /// True if a search can begin: the field of an unlocked target is shown.
  bool isPossible() const;
  bool isSearching() const { return runner_.isRunning(); }
  void search();
  /// True if a better pose was found for the present plan.
  bool hasProposal() const { return proposal_ && proposal_->best > proposal_->planned; }
  /// Gives the target the proposed pose.
  void take();
  /// "turned 20° clockwise, 5 mm forwards: 52 V/m in place of 45; +16 % at the target, maximum 4 mm away,
  /// correlation 0.97"; that it is being searched; or empty.
  QString words() const;

 signals:
  void changed();

 private:
  void forget();

  FieldPresenter& field_;
  PlanPresenter& plan_;
  CaseModel& model_;
  QSettings settings_;
  TaskRunner runner_;
  steps::FieldAim aim_ = steps::FieldAim::strength;
  std::optional<steps::BestPose> proposal_;
  steps::PoseComparison compared_;  // of the proposal with the planned pose
  QString failure_;
  int wish_ = 0, searched_wish_ = 0;
};

}  // namespace facenav::ui
