#include "plan/field_presenter.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "facenav/core/error.h"
#include "prepare/prepare_queue.h"

namespace facenav::ui {
namespace {

const char* const kFieldShown = "plan/field_shown";
const char* const kFieldCoil = "plan/field_coil";
const char* const kFieldRate = "plan/field_rate";
const char* const kFieldRateIsPercent = "plan/field_rate_is_pct";
const char* const kPrefersImported = "plan/field_imported";

steps::CurrentRate limitedRate(steps::CurrentRate rate) {
  rate.value = std::clamp(rate.value, kLeastRate, mostRate(rate.unit));
  return rate;
}

bool isSamePose(const guidance::Target& left, const guidance::Target& right) {
  return left.mri_T_target.rotation() == right.mri_T_target.rotation() &&
         left.mri_T_target.translation_mm() == right.mri_T_target.translation_mm() &&
         left.cortex_point.mm == right.cortex_point.mm;
}

bool isSameImport(const std::optional<steps::ImportedField>& a,
                  const std::optional<steps::ImportedField>& b) {
  return a && b ? a->file == b->file && a->utc == b->utc : !a && !b;
}

bool isSameWish(const std::optional<steps::WantedField>& a, const std::optional<steps::WantedField>& b) {
  if (!a || !b) return !a && !b;
  const bool is_against_same =
      a->against && b->against ? a->against->name == b->against->name && isSamePose(*a->against, *b->against)
                               : !a->against && !b->against;
  return isSamePose(a->target, b->target) && a->coil == b->coil && a->rate == b->rate &&
         a->drawn == b->drawn && a->threshold == b->threshold && is_against_same &&
         isSameImport(a->imported, b->imported);
}

/// Reads the case, or takes what was read unless another model was written meanwhile.
std::shared_ptr<const steps::ReadHead> currentHead(const casefile::CaseStore& store,
                                                   std::shared_ptr<const steps::ReadHead> known) {
  return known && known->isCurrent(store) ? known : std::make_shared<const steps::ReadHead>(store);
}

}  // namespace

double mostRate(steps::CurrentRate::Unit unit) {
  return unit == steps::CurrentRate::Unit::output_pct ? 100 : 1000;
}

QString rememberedFieldCoil() {
  return QSettings().value(kFieldCoil, QString::fromStdString(efield::builtInCoils().front())).toString();
}

steps::CurrentRate rememberedFieldRate() {
  const QSettings settings;
  steps::CurrentRate rate;
  rate.unit = settings.value(kFieldRateIsPercent, false).toBool() ? steps::CurrentRate::Unit::output_pct
                                                                  : steps::CurrentRate::Unit::A_per_us;
  rate.value = settings.value(kFieldRate, rate.value).toDouble();
  return limitedRate(rate);
}

FieldPresenter::FieldPresenter(PlanPresenter& plan, CaseModel& model, QObject* parent)
    : QObject(parent), plan_(plan), model_(model), fluid_(model) {
  is_on_ = settings_.value(kFieldShown, false).toBool();
  coil_ = rememberedFieldCoil();
  rate_ = rememberedFieldRate();
  prefers_imported_ = settings_.value(kPrefersImported, true).toBool();
  for (auto signal : {&CaseModel::opened, &CaseModel::brainChanged})
    connect(&model_, signal, this, &FieldPresenter::forgetCase);
  connect(&plan_, &PlanPresenter::changed, this, &FieldPresenter::follow);
  connect(&runner_, &TaskRunner::failed, this, &FieldPresenter::fail);
  connect(&fluid_, &FluidPresenter::built, this, &FieldPresenter::takeNewModel);
  connect(&fluid_, &FluidPresenter::failed, this, &FieldPresenter::changed);
  for (auto signal : {&TaskRunner::succeeded, &TaskRunner::cancelled})
    connect(&runner_, signal, this, &FieldPresenter::compute);
  connect(&runner_, &TaskRunner::failed, this, &FieldPresenter::compute);
}

void FieldPresenter::setOn(bool is_on) {
  if (std::exchange(is_on_, is_on) == is_on) return;
  settings_.setValue(kFieldShown, is_on);
  followChoice();
}

void FieldPresenter::setCoil(const QString& name_or_file) {
  coil_ = name_or_file;
  settings_.setValue(kFieldCoil, coil_);
  followChoice();
}

void FieldPresenter::setRate(const steps::CurrentRate& rate) {
  rate_ = limitedRate(rate);
  settings_.setValue(kFieldRate, rate_.value);
  settings_.setValue(kFieldRateIsPercent, rate_.unit == steps::CurrentRate::Unit::output_pct);
  followChoice();
}

void FieldPresenter::preferImported(bool is_preferred) {
  if (std::exchange(prefers_imported_, is_preferred) == is_preferred) return;
  settings_.setValue(kPrefersImported, is_preferred);
  followChoice();
}

void FieldPresenter::setAgainst(const QString& target) {
  against_ = target;
  follow();
}

void FieldPresenter::buildBy(PrepareQueue& queue) {
  queue_ = &queue;
  connect(&queue, &PrepareQueue::fieldEnded, this, &FieldPresenter::takeModel);
}

/// Computes again after the model of the open case was built.
void FieldPresenter::takeModel(const QString& folder, const QString& failure) {
  if (!model_.isOpen() || folder.toStdString() != model_.current().store.folder().string()) return;
  build_failure_ = failure;
  restart();
}

void FieldPresenter::fail(const QString& words) {
  if (computed_wish_ != wish_) return;
  if (is_reaching_) {
    reach_ = steps::PlannedReach();  // the field itself is shown
    emit reachChanged();
    return;
  }
  failure_ = words;
  emit changed();
}

void FieldPresenter::followChoice() {
  const int before = wish_;
  follow();
  if (wish_ == before) emit changed();  // for what shows the choices
}

void FieldPresenter::setInSight(bool is_in_sight) {
  if (!std::exchange(is_in_sight_, is_in_sight) && is_in_sight) readThreshold();
  follow();
}

void FieldPresenter::setDrawn(std::shared_ptr<const surface::TriangleMesh> drawn) {
  drawn_ = std::move(drawn);
  follow();
}

void FieldPresenter::forgetCase() {
  ++subject_;
  head_.reset();
  labels_.reset();
  drawn_.reset();
  wanted_.reset();
  has_asked_ = false;
  build_failure_.clear();
  readThreshold();
  restart();
  follow();
}

/// Reads the case's motor threshold, which a session may have found since.
void FieldPresenter::readThreshold() {
  threshold_.reset();
  if (model_.isOpen()) threshold_ = steps::hotspotThreshold(model_.current().store.folder());
}

/// Finds the field that was imported for the pose that the active target has now.
void FieldPresenter::readImported() {
  imported_.reset();
  if (!model_.isOpen() || !plan_.active()) return;
  try {
    imported_ = steps::importedField(model_.current().store, *plan_.active());
  } catch (const Error&) {  // damaged: 'facenav field' says so; here the field is computed
  }
}

/// Drops the field if it is no longer that of the plan, and computes the new one.
void FieldPresenter::follow() {
  const bool had_imported = hasImported();
  readImported();
  std::optional<steps::WantedField> next;
  if (is_on_ && is_in_sight_ && model_.isOpen() && plan_.active()) {
    next = steps::WantedField{*plan_.active(), coil_.toStdString(), rate_, drawn_};
    next->threshold = threshold_;
    if (prefers_imported_) next->imported = imported_;
    const auto* other = steps::find(plan_.plan(), against_.toStdString());
    if (other && other->name != next->target.name) next->against = *other;
  }
  if (isSameWish(next, wanted_)) {
    if (had_imported != hasImported()) emit changed();  // for what shows the choices
    return;
  }
  wanted_ = std::move(next);
  restart();
}

/// Takes away what is shown and begins the present wish.
void FieldPresenter::restart() {
  ++wish_;
  shown_.reset();
  reach_.reset();
  failure_.clear();
  runner_.cancel();
  emit changed();
  emit reachChanged();
  compute();
}

/// The case has a surer model now.
void FieldPresenter::takeNewModel() {
  ++subject_;
  head_.reset();
  restart();
}

void FieldPresenter::compute() {
  if (!wanted_ || !failure_.isEmpty() || runner_.isRunning()) return;
  computed_wish_ = wish_;
  is_reaching_ = shown_.has_value();
  if (!shown_) computeField();
  if (shown_ && !reach_ && head_) computeReach();
}

void FieldPresenter::computeField() {
  runner_.start(tr("Electric field"),
                [this, wish = wish_, subject = subject_, wanted = *wanted_, known = head_,
                 store = model_.current().store](TaskMonitor& monitor) -> TaskRunner::Delivery {
                  const auto head = currentHead(store, known);
                  keep(head, subject);
                  monitor.report("electric field", 0.1);
                  const auto made = steps::plannedField(*head, wanted, monitor);
                  return [this, wish, made] {
                    if (wish != wish_) return;  // succeeded() begins the newest wish
                    shown_ = made;
                    emit changed();
                  };
                });
}

void FieldPresenter::computeReach() {
  runner_.start(tr("Electric field"),
                [this, wish = wish_, subject = subject_, wanted = *wanted_, head = head_, known = labels_,
                 store = model_.current().store](TaskMonitor& monitor) -> TaskRunner::Delivery {
                  const auto labels =
                      known ? known : std::make_shared<const steps::LabelOf>(steps::aalLabels(store));
                  const auto reach = steps::plannedReach(*head, wanted, *labels, monitor);
                  return [this, wish, subject, reach, labels] {
                    if (subject == subject_) labels_ = labels;
                    if (wish != wish_) return;
                    reach_ = reach;
                    emit reachChanged();
                  };
                });
}

/// Keeps what was read of the case, also if the field itself is cancelled. Called on the worker thread.
void FieldPresenter::keep(std::shared_ptr<const steps::ReadHead> head, int subject) {
  QMetaObject::invokeMethod(
      this,
      [this, head = std::move(head), subject] {
        if (subject != subject_) return;  // it is another case's
        head_ = head;
        if (!queue_ || !head_->isOutdated() || std::exchange(has_asked_, true)) return;
        queue_->buildField(QString::fromStdString(model_.current().store.folder().string()));
      },
      Qt::QueuedConnection);
}

std::optional<scene::FieldPicture> FieldPresenter::picture() const {
  if (!shown_ || !wanted_ || !wanted_->drawn || shown_->strength.empty()) return std::nullopt;
  const QString peak = tr("maximum %1 V/m").arg(strengthFigure(shown_->peak));
  return scene::FieldPicture{wanted_->drawn, shown_->strength, shown_->peak, shown_->peak_place,
                             peak.toStdString()};
}

std::optional<scene::Overlay> FieldPresenter::sliceOverlay() const {
  if (!shown_ || !reach_ || !reach_->in_brain || !model_.isOpen() || !model_.current().brain_mask)
    return std::nullopt;
  return scene::fieldOverlay(reach_->in_brain, model_.current().brain_mask, shown_->peak);
}

}  // namespace facenav::ui
