#include "treat/live_field_presenter.h"

#include <QSettings>
#include <cmath>
#include <utility>

#include "plan/field_presenter.h"
#include "shell/shown_words.h"

namespace facenav::ui {
namespace {

constexpr const char* kFieldShown = "treat/field_shown";

}  // namespace

LiveFieldPresenter::LiveFieldPresenter(TreatPresenter& treat, CaseModel& model, QObject* parent)
    : QObject(parent), treat_(treat), model_(model), is_on_(QSettings().value(kFieldShown, false).toBool()) {
  for (auto signal : {&CaseModel::opened, &CaseModel::brainChanged})
    connect(&model_, signal, this, [this] {
      drawn_.reset();
      readChoices();
      use();
    });
}

void LiveFieldPresenter::setOn(bool is_on) {
  if (std::exchange(is_on_, is_on) == is_on) return;
  QSettings().setValue(kFieldShown, is_on);
  if (is_on_)
    readChoices();
  else
    rest();
  use();
}

void LiveFieldPresenter::readChoices() {
  auto threshold = model_.isOpen() ? steps::hotspotThreshold(model_.current().store.folder()) : std::nullopt;
  const QString coil = rememberedFieldCoil();
  planned_rate_ = rememberedFieldRate();
  const bool is_same = coil == coil_ && threshold == threshold_;
  coil_ = coil;
  threshold_ = std::move(threshold);
  if (!is_same) use();
}

/// Tells the worker what is wanted now. The dose needs it also while the field is not shown.
void LiveFieldPresenter::use() {
  shown_.reset();
  drawn_.reset();
  const bool is_wanted = model_.isOpen() && model_.current().brain && (is_on_ || threshold_);
  if (is_wanted) {
    const auto& loaded = model_.current();
    drawn_ = {loaded.brain, &loaded.brain->mesh};
    worker_.use(
        steps::LiveFieldSubject{loaded.store, coil_.toStdString(), is_on_ ? drawn_ : nullptr, threshold_});
  } else {
    worker_.use(std::nullopt);
  }
  emit changed();
}

void LiveFieldPresenter::follow(const session::NavigationState& state) {
  if (threshold_)
    if (const auto* target = treat_.target()) worker_.plan(*target);
  followDose();
  if (!is_on_) return;
  worker_.follow(treat_.guidedStates());  // none in a pause
  is_paused_ = treat_.isPaused();
  has_pose_ = !is_paused_ && steps::livePose(state);
  gap_mm_ = state.gap.by_poses_mm;
  shown_ = worker_.latest();
  if (shown_ && !(has_pose_ && steps::mayBeShown(*shown_, state))) shown_.reset();
  emit changed();
}

void LiveFieldPresenter::rest() {
  worker_.follow(nullptr);
  shown_.reset();
}

void LiveFieldPresenter::followDose() {
  const auto planned = threshold_ ? worker_.planned() : nullptr;
  const QString words = planned && planned->dose ? doseWords(*planned->dose) : QString();
  if (std::exchange(dose_words_, words) != words) emit doseChanged();
}

/// The output that is set, where the coil's file has its largest rate; else the rate that was set in Plan.
std::optional<double> LiveFieldPresenter::rate_A_per_us() const {
  if (!shown_) return std::nullopt;
  const double largest = shown_->largest_didt_A_per_us;
  const bool is_pct = planned_rate_.unit == steps::CurrentRate::Unit::output_pct;
  if (treat_.intensity() && largest > 0) return largest * *treat_.intensity() / 100;
  if (is_pct && largest > 0) return largest * planned_rate_.value / 100;
  return is_pct ? std::nullopt : std::optional(planned_rate_.value);
}

double LiveFieldPresenter::factor() const { return rate_A_per_us().value_or(1); }

std::optional<scene::FieldPicture> LiveFieldPresenter::picture() const {
  if (!is_on_ || !shown_ || !drawn_ || shown_->strength.size() != drawn_->vertices_mm.size() ||
      !(shown_->peak > 0))
    return std::nullopt;
  scene::FieldPicture picture{drawn_, shown_->strength, factor() * shown_->peak, shown_->peak_place};
  for (float& strength : picture.strength) strength *= float(factor());
  picture.peak_words = tr("maximum %1 %2").arg(strengthFigure(picture.peak), strengthUnit()).toStdString();
  return picture;
}

QString LiveFieldPresenter::strengthUnit() const {
  return !shown_ || rate_A_per_us() ? tr("V/m") : tr("V/m per A/us");
}

QString LiveFieldPresenter::barWords() const {
  return shown_ ? tr("|E|, tier %1").arg(int(shown_->tier)) : QString();
}

QString LiveFieldPresenter::rateWords() const {
  const auto rate = rate_A_per_us();
  if (!rate) return tr("for 1 A/us: the coil's file does not say its rate");
  const bool by_output = treat_.intensity() && shown_->largest_didt_A_per_us > 0;
  return by_output
             ? tr("at %1 % of the output (%2 A/us)").arg(*treat_.intensity(), 0, 'g', 3).arg(*rate, 0, 'g', 3)
             : tr("at %1 A/us, as set in Plan").arg(*rate, 0, 'g', 4);
}

/// ", 97 % of the planned pose, 88 % of the threshold"; parts that are not known are left out.
QString LiveFieldPresenter::shareWords() const {
  QString words;
  if (shown_->planned && *shown_->planned > 0)
    words += tr(", %1 % of the planned pose").arg(std::lround(100 * *shown_->at_target / *shown_->planned));
  const auto planned = worker_.planned();
  if (planned && planned->dose && treat_.intensity())
    words += tr(", %1 % of the motor threshold")
                 .arg(std::lround(steps::ofThreshold_pct(*shown_, *treat_.intensity(), *planned->dose)));
  return words;
}

QString LiveFieldPresenter::missingWords() const {
  const QString failure = shownWords(worker_.failure());
  if (!model_.isOpen()) return tr("no field: no case is open");
  if (!failure.isEmpty()) return tr("no field: %1").arg(failure);
  if (!model_.current().brain) return tr("no field: the case has no brain");
  if (is_paused_) return tr("no field in a pause");
  if (!has_pose_) return tr("no field: the pose of head or coil is not known");
  return tr("computing the electric field \u2026");
}

QString LiveFieldPresenter::words() const {
  if (!is_on_) return {};
  if (!shown_) return missingWords();
  const double f = factor();
  QString words;
  if (shown_->at_target)
    words = tr("E at target %1 %2 (%3 to %4)")
                .arg(strengthFigure(f * *shown_->at_target), strengthUnit(),
                     strengthFigure(f * shown_->range.low), strengthFigure(f * shown_->range.high)) +
            shareWords() + "; ";
  words += tr("maximum %1 %2").arg(strengthFigure(f * shown_->peak), strengthUnit());
  if (shown_->target)
    words += tr(", %1 mm from the target")
                 .arg(std::lround((shown_->peak_place.mm - shown_->target->cortex_point.mm).norm()));
  const QString gap = gap_mm_ ? tr("measured gap %1 mm; ").arg(*gap_mm_, 0, 'f', 1) : QString();
  return words + "\n" + rateWords() + "; " + gap +
         tr("tier %1: %2, usual error %3 %")
             .arg(int(shown_->tier))
             .arg(modelWords(shown_->tier))
             .arg(std::lround(100 * shown_->usual_error));
}

}  // namespace facenav::ui
