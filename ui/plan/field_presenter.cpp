#include "plan/field_presenter.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "facenav/prepare/case_field.h"

namespace facenav::ui {
namespace {

const char* const kFieldShown = "plan/field_shown";
const char* const kFieldCoil = "plan/field_coil";
const char* const kFieldRate = "plan/field_rate";
const char* const kFieldRateIsPercent = "plan/field_rate_is_pct";

steps::CurrentRate limitedRate(steps::CurrentRate rate) {
  rate.value = std::clamp(rate.value, kLeastRate, mostRate(rate.unit));
  return rate;
}

bool isSameWish(const std::optional<steps::WantedField>& a, const std::optional<steps::WantedField>& b) {
  if (!a || !b) return !a && !b;
  const auto& left = a->target;
  const auto& right = b->target;
  return left.mri_T_target.rotation() == right.mri_T_target.rotation() &&
         left.mri_T_target.translation_mm() == right.mri_T_target.translation_mm() &&
         left.cortex_point.mm == right.cortex_point.mm && a->coil == b->coil && a->rate == b->rate &&
         a->drawn == b->drawn && a->threshold == b->threshold;
}

/// Reads the case, or takes what was read unless a better model was built meanwhile.
std::shared_ptr<const steps::ReadHead> currentHead(const casefile::CaseStore& store,
                                                   std::shared_ptr<const steps::ReadHead> known) {
  const bool is_best = known && (known->tier() != steps::FieldTier::local_sphere ||
                                 !std::filesystem::exists(steps::fieldFile(store)));
  return is_best ? known : std::make_shared<const steps::ReadHead>(store);
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

QString doseWords(const steps::ThresholdDose& dose) {
  const QString words = FieldPresenter::tr(
                            "dose by field: %1 % of the output gives this target the field that "
                            "%2 had at its threshold of %3 %")
                            .arg(std::lround(dose.output_pct))
                            .arg(QString::fromStdString(dose.hotspot))
                            .arg(std::lround(dose.threshold_pct));
  return dose.output_pct > 100 ? words + FieldPresenter::tr(": more than the stimulator has") : words;
}

QString strengthFigure(double strength) {
  return QString::number(strength, 'f', strength >= 10 ? 0 : strength >= 1 ? 1 : 2);
}

FieldPresenter::FieldPresenter(PlanPresenter& plan, CaseModel& model, QObject* parent)
    : QObject(parent), plan_(plan), model_(model) {
  is_on_ = settings_.value(kFieldShown, false).toBool();
  coil_ = rememberedFieldCoil();
  rate_ = rememberedFieldRate();
  for (auto signal : {&CaseModel::opened, &CaseModel::brainChanged})
    connect(&model_, signal, this, &FieldPresenter::forgetCase);
  connect(&plan_, &PlanPresenter::changed, this, &FieldPresenter::follow);
  connect(&runner_, &TaskRunner::failed, this, [this](const QString& words) {
    if (computed_wish_ != wish_) return;
    failure_ = words;
    emit changed();
  });
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

void FieldPresenter::followChoice() {
  const int before = wish_;
  follow();
  if (wish_ == before) emit changed();  // for what shows the choices
}

void FieldPresenter::setInSight(bool is_in_sight) {
  if (std::exchange(is_in_sight_, is_in_sight) != is_in_sight) readThreshold();
  follow();
}

void FieldPresenter::setDrawn(std::shared_ptr<const surface::TriangleMesh> drawn) {
  drawn_ = std::move(drawn);
  follow();
}

void FieldPresenter::forgetCase() {
  ++subject_;
  head_.reset();
  drawn_.reset();
  wanted_.reset();
  shown_.reset();
  failure_.clear();
  readThreshold();
  ++wish_;
  emit changed();
  follow();
}

/// Reads the case's motor threshold, which a session may have found since.
void FieldPresenter::readThreshold() {
  threshold_.reset();
  if (model_.isOpen()) threshold_ = steps::hotspotThreshold(model_.current().store.folder());
}

/// Drops the field if it is no longer that of the plan, and computes the new one.
void FieldPresenter::follow() {
  std::optional<steps::WantedField> next;
  if (is_on_ && is_in_sight_ && model_.isOpen() && plan_.active())
    next = steps::WantedField{*plan_.active(), coil_.toStdString(), rate_, drawn_, threshold_};
  if (isSameWish(next, wanted_)) return;
  wanted_ = std::move(next);
  ++wish_;
  shown_.reset();
  failure_.clear();
  runner_.cancel();
  emit changed();
  compute();
}

void FieldPresenter::compute() {
  if (!wanted_ || shown_ || !failure_.isEmpty() || runner_.isRunning()) return;
  computed_wish_ = wish_;
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

/// Keeps what was read of the case, also if the field itself is cancelled. Called on the worker thread.
void FieldPresenter::keep(std::shared_ptr<const steps::ReadHead> head, int subject) {
  QMetaObject::invokeMethod(
      this,
      [this, head = std::move(head), subject] {
        if (subject == subject_) head_ = head;  // otherwise it is another case's
      },
      Qt::QueuedConnection);
}

std::optional<scene::FieldPicture> FieldPresenter::picture() const {
  if (!shown_ || !wanted_ || !wanted_->drawn || shown_->strength.empty()) return std::nullopt;
  const QString peak = tr("maximum %1 V/m").arg(strengthFigure(shown_->peak));
  return scene::FieldPicture{wanted_->drawn, shown_->strength, shown_->peak, shown_->peak_place,
                             peak.toStdString()};
}

QString FieldPresenter::words() const {
  if (!is_on_ || !model_.isOpen()) return {};
  if (!plan_.active()) return tr("no target chosen, so there is no field");
  if (!failure_.isEmpty()) return failure_;
  if (!shown_) return tr("computing the electric field \u2026");
  const QString model =
      shown_->tier == steps::FieldTier::local_sphere ? tr("a local sphere") : tr("three shells");
  const QString strengths =
      tr("E at target %1 V/m, along the normal %2; maximum %3 V/m, %4 mm from the target")
          .arg(strengthFigure(shown_->at_target), strengthFigure(shown_->along_normal),
               strengthFigure(shown_->peak))
          .arg(std::lround(shown_->peak_distance_mm));
  const QString dose = shown_->dose ? "\n" + doseWords(*shown_->dose) : QString();
  return strengths +
         tr("; at %1 A/us; tier %2: %3, usual error %4 %")
             .arg(shown_->rate_A_per_us, 0, 'g', 4)
             .arg(int(shown_->tier))
             .arg(model)
             .arg(std::lround(100 * shown_->usual_error)) +
         dose;
}

QString FieldPresenter::barWords() const {
  return shown_ ? tr("|E|, tier %1").arg(int(shown_->tier)) : QString();
}

}  // namespace facenav::ui
