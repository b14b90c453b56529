#include "plan/best_pose_presenter.h"

#include <cmath>

namespace facenav::ui {
namespace {

const char* const kBestPoseAim = "plan/best_pose_along_normal";

/// "turned 20 degrees clockwise, 5 mm forwards, 10 mm to the left", seen from above: the coil's x points
/// left.
QString bestMoveWords(const steps::BestPose& best) {
  const long turned_deg = std::lround(best.turned_deg), left_mm = std::lround(best.x_mm),
             ahead_mm = std::lround(best.y_mm);
  QStringList parts;
  if (turned_deg != 0)
    parts << (turned_deg > 0 ? BestPosePresenter::tr("turned %1\u00b0 clockwise")
                             : BestPosePresenter::tr("turned %1\u00b0 anticlockwise"))
                 .arg(std::abs(turned_deg));
  if (ahead_mm != 0)
    parts << (ahead_mm > 0 ? BestPosePresenter::tr("%1 mm forwards")
                           : BestPosePresenter::tr("%1 mm backwards"))
                 .arg(std::abs(ahead_mm));
  if (left_mm != 0)
    parts << (left_mm > 0 ? BestPosePresenter::tr("%1 mm to the left")
                          : BestPosePresenter::tr("%1 mm to the right"))
                 .arg(std::abs(left_mm));
  return parts.isEmpty() ? BestPosePresenter::tr("less than 1 mm away") : parts.join(", ");
}

}  // namespace

BestPosePresenter::BestPosePresenter(FieldPresenter& field, PlanPresenter& plan, CaseModel& model,
                                     QObject* parent)
    : QObject(parent), field_(field), plan_(plan), model_(model) {
  if (settings_.value(kBestPoseAim, false).toBool()) aim_ = steps::FieldAim::along_normal;
  connect(&field_, &FieldPresenter::changed, this, &BestPosePresenter::forget);
  connect(&plan_, &PlanPresenter::changed, this, &BestPosePresenter::changed);  // locked or unlocked
  connect(&runner_, &TaskRunner::failed, this, [this](const QString& words) {
    if (searched_wish_ == wish_) failure_ = words;
    emit changed();
  });
  for (auto signal : {&TaskRunner::succeeded, &TaskRunner::cancelled})
    connect(&runner_, signal, this, &BestPosePresenter::changed);
}

/// Drops a proposal that belongs to another field.
void BestPosePresenter::forget() {
  ++wish_;
  proposal_.reset();
  failure_.clear();
  runner_.cancel();
  emit changed();
}

void BestPosePresenter::setAim(steps::FieldAim aim) {
  aim_ = aim;
  settings_.setValue(kBestPoseAim, aim == steps::FieldAim::along_normal);
  forget();
}

bool BestPosePresenter::isPossible() const {
  return field_.shown() && field_.head() && plan_.active() && !plan_.active()->is_locked && !isSearching();
}

void BestPosePresenter::search() {
  if (!isPossible()) return;
  forget();
  searched_wish_ = wish_;
  const auto& c = model_.current();
  runner_.start(tr("Best pose"),
                [this, wish = wish_, wanted = *field_.wanted(), head = field_.head(), aim = aim_,
                 planned = steps::PlannedHead{c.scalp, c.head_mask, c.brain, c.coil.plate}](
                    TaskMonitor& monitor) -> TaskRunner::Delivery {
                  const auto best = steps::bestPlannedPose(*head, planned, wanted, aim, monitor);
                  const auto compared = steps::comparePlanned(*head, wanted, best.target);
                  return [this, wish, best, compared] {
                    if (wish != wish_) return;
                    proposal_ = best;
                    compared_ = compared;
                  };
                });
  emit changed();
}

void BestPosePresenter::take() {
  if (!hasProposal() || !plan_.active()) return;
  const guidance::Target pose = proposal_->target;  // the step drops the proposal
  plan_.takePose(pose, "best pose");
}

QString BestPosePresenter::words() const {
  if (isSearching() && searched_wish_ == wish_) return tr("searching 36 angles at 25 places \u2026");
  if (!failure_.isEmpty()) return failure_;
  if (!proposal_) return {};
  const QString now = strengthFigure(proposal_->planned);
  if (!hasProposal()) return tr("the planned pose is the best one: %1 V/m").arg(now);
  return tr("%1: %2 V/m in place of %3; %4")
      .arg(bestMoveWords(*proposal_), strengthFigure(proposal_->best), now, differenceWords(compared_));
}

}  // namespace facenav::ui
