#pragma once
// FieldPresenter: the electric field of the active target's planned pose (plan/planned_field.h), computed in
// the background while the page is in sight. The newest wish wins; whatever changes takes the old field away
// at once.

#include <QObject>
#include <QSettings>

#include "facenav/plan/planned_field.h"
#include "facenav/scene/field_layer.h"
#include "plan/plan_presenter.h"
#include "shell/task_runner.h"

namespace facenav::ui {

class FieldPresenter : public QObject {
  Q_OBJECT

 public:
  FieldPresenter(PlanPresenter& plan, CaseModel& model, QObject* parent = nullptr);

  // The user's choices, remembered (QSettings).
  bool isOn() const { return is_on_; }
  void setOn(bool is_on);
  /// Name of a built-in coil, or path of a coil's file.
  QString coil() const { return coil_; }
  void setCoil(const QString& name_or_file);
  steps::CurrentRate rate() const { return rate_; }
  void setRate(const steps::CurrentRate& rate);

  /// Sets whether the page is in sight; nothing is computed while it is not.
  void setInSight(bool is_in_sight);
  /// Sets the surface that the 3-D view draws; null: none.
  void setDrawn(std::shared_ptr<const surface::TriangleMesh> drawn);

  /// What the field is wanted for; nothing while it is off, out of sight or without a target.
  const std::optional<steps::WantedField>& wanted() const { return wanted_; }
  /// The field of wanted(); null until it is computed.
  const steps::PlannedField* shown() const { return shown_ ? &*shown_ : nullptr; }
  std::optional<scene::FieldPicture> picture() const;
  /// Surfaces and model of the case for another task; null until they are read.
  std::shared_ptr<const steps::ReadHead> head() const { return head_; }
  /// "E at target 45 V/m, along the normal 18; maximum 80 V/m, 12 mm from the target; .."; what is missing;
  /// or empty.
  QString words() const;
  /// "|E|, tier 1": name of the colour bar, whose unit is V/m.
  QString barWords() const;

 signals:
  void changed();

 private:
  void forgetCase();
  void readThreshold();
  void follow();
  void followChoice();
  void compute();
  void keep(std::shared_ptr<const steps::ReadHead> head, int subject);

  PlanPresenter& plan_;
  CaseModel& model_;
  QSettings settings_;
  TaskRunner runner_;
  bool is_on_ = false, is_in_sight_ = false;
  QString coil_, failure_;
  steps::CurrentRate rate_;
  std::shared_ptr<const surface::TriangleMesh> drawn_;
  std::optional<steps::HotspotThreshold> threshold_;
  std::shared_ptr<const steps::ReadHead> head_;
  std::optional<steps::WantedField> wanted_;
  std::optional<steps::PlannedField> shown_;
  int wish_ = 0, computed_wish_ = 0, subject_ = 0;
};

/// Range of a rate, of its unit.
constexpr double kLeastRate = 0.1;
double mostRate(steps::CurrentRate::Unit unit);

/// Coil and rate of the last choice, for other pages.
QString rememberedFieldCoil();
steps::CurrentRate rememberedFieldRate();

/// "dose by field: 57 % of the output gives this target the field that M1 hand L had at its threshold of 48
/// %"; with a caution if that is more than 100 %.
QString doseWords(const steps::ThresholdDose& dose);

/// Strength with two digits or more: "45", "4.5", "0.45".
QString strengthFigure(double strength);

}  // namespace facenav::ui
