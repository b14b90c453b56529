#pragma once
// FieldPresenter: the electric field of the active target's planned pose (plan/planned_field.h), computed in
// the background while the page is in sight: the field on the cortex first, then the region that it reaches.
// The newest wish wins; whatever changes takes the old field away at once.

#include <QObject>
#include <QPointer>
#include <QSettings>

#include "facenav/plan/planned_field.h"
#include "facenav/scene/field_layer.h"
#include "plan/fluid_presenter.h"
#include "plan/plan_presenter.h"
#include "shell/task_runner.h"

namespace facenav::ui {

class PrepareQueue;

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

  /// True if a field was imported for the active target's pose (tier 3).
  bool hasImported() const { return imported_.has_value(); }
  /// Shows the imported field in place of the computed one, where there is one.
  bool prefersImported() const { return prefers_imported_; }
  void preferImported(bool is_preferred);

  /// Sets the target whose pose is compared with the active one's; empty: none.
  void setAgainst(const QString& target);
  /// Has models of the head that are older than their masks built again by this queue.
  void buildBy(PrepareQueue& queue);

  /// Sets whether the page is in sight; nothing is computed while it is not.
  void setInSight(bool is_in_sight);
  /// Sets the surface that the 3-D view draws; null: none.
  void setDrawn(std::shared_ptr<const surface::TriangleMesh> drawn);

  /// Builds the model with the fluid; the field is then computed again with it.
  FluidPresenter& fluid() { return fluid_; }

  /// What the field is wanted for; nothing while it is off, out of sight or without a target.
  const std::optional<steps::WantedField>& wanted() const { return wanted_; }
  /// The field of wanted(); null until it is computed.
  const steps::PlannedField* shown() const { return shown_ ? &*shown_ : nullptr; }
  std::optional<scene::FieldPicture> picture() const;
  /// What the field reaches; null until it is computed, some time after shown().
  const steps::PlannedReach* reach() const { return reach_ ? &*reach_ : nullptr; }
  /// The field for the slices, in the brain alone.
  std::optional<scene::Overlay> sliceOverlay() const;
  /// "above 50 %: 2140 mm2 of cortex, 12.1 ml of the brain", below it "Precentral_L 4.1, ..", the same for 75
  /// and 90 %; or empty.
  QString reachWords() const;
  /// "against 'DLPFC': -12 % at the target, maximum 9 mm away, correlation 0.87"; or empty.
  QString againstWords() const;
  /// Surfaces and model of the case for another task; null until they are read.
  std::shared_ptr<const steps::ReadHead> head() const { return head_; }
  /// "E at target 45 V/m, along the normal 18; maximum 80 V/m, 12 mm from the target; .."; what is missing;
  /// or empty.
  QString words() const;
  /// "|E|, tier 1": name of the colour bar, whose unit is V/m.
  QString barWords() const;

 signals:
  void changed();
  /// reach() is there, or taken away.
  void reachChanged();

 private:
  void forgetCase();
  void readThreshold();
  void readImported();
  void follow();
  void followChoice();
  void restart();
  void compute();
  void computeField();
  void computeReach();
  void fail(const QString& words);
  void takeModel(const QString& folder, const QString& failure);
  QString oldModelWords() const;
  QString importedWords() const;
  void takeNewModel();
  void keep(std::shared_ptr<const steps::ReadHead> head, int subject);

  PlanPresenter& plan_;
  CaseModel& model_;
  FluidPresenter fluid_;
  QSettings settings_;
  TaskRunner runner_;
  bool is_on_ = false, is_in_sight_ = false, prefers_imported_ = false;
  QString coil_, failure_, against_, build_failure_;
  steps::CurrentRate rate_;
  std::shared_ptr<const surface::TriangleMesh> drawn_;
  std::optional<steps::HotspotThreshold> threshold_;
  std::optional<steps::ImportedField> imported_;
  std::shared_ptr<const steps::ReadHead> head_;
  std::optional<steps::WantedField> wanted_;
  std::optional<steps::PlannedField> shown_;
  std::optional<steps::PlannedReach> reach_;
  std::shared_ptr<const steps::LabelOf> labels_;  // of the case; null until they are read
  QPointer<PrepareQueue> queue_;
  bool is_reaching_ = false, has_asked_ = false;  // which of both is computed; the queue was asked
  int wish_ = 0, computed_wish_ = 0, subject_ = 0;
};

/// "-12 % at the target, maximum 9 mm away, correlation 0.87".
QString differenceWords(const steps::PoseComparison& compared);

/// Range of a rate, of its unit.
constexpr double kLeastRate = 0.1;
double mostRate(steps::CurrentRate::Unit unit);

/// Coil and rate of the last choice, for other pages.
QString rememberedFieldCoil();
steps::CurrentRate rememberedFieldRate();

/// "dose by field: 57 % of the output gives this target the field that M1 hand L had at its threshold of 48
/// %"; with a caution if that is more than 100 %.
QString doseWords(const steps::ThresholdDose& dose);

/// The model of the head in words: "three shells".
QString modelWords(steps::FieldTier tier);
/// Strength with two digits or more: "45", "4.5", "0.45".
QString strengthFigure(double strength);

}  // namespace facenav::ui
