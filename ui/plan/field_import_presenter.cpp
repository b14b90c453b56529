#include "plan/field_import_presenter.h"

#include <utility>

#include "plan/other_words.h"

namespace facenav::ui {

FieldImportPresenter::FieldImportPresenter(CaseModel& model, PlanPresenter& plan, QObject* parent)
    : QObject(parent), model_(model), plan_(plan) {
  for (const auto ended : {&TaskRunner::succeeded, &TaskRunner::cancelled})
    connect(&reader_, ended, this, &FieldImportPresenter::goOn);
  connect(&reader_, &TaskRunner::failed, this, [this](const QString& words) {
    if (is_outdated_) return goOn();  // another answer was given meanwhile
    field_.reset();
    failure_ = inWindowWords(words.toStdString());
    emit changed();
  });
}

void FieldImportPresenter::open(const QString& file, const QString& surface) {
  order_ = {};
  order_.file = file.toStdString();
  order_.surface = surface.toStdString();
  order_.target = plan_.activeName().toStdString();
  const QStringList names = targets();
  if (order_.target.empty() && !names.isEmpty()) order_.target = names.front().toStdString();
  needs_surface_ = steps::needsSurface(order_.file);
  judge();
}

QStringList FieldImportPresenter::targets() const {
  QStringList names;
  for (const auto& target : plan_.plan().targets) names << QString::fromStdString(target.name);
  return names;
}

void FieldImportPresenter::setTarget(const QString& name) {
  order_.target = name.toStdString();
  judge();
}

void FieldImportPresenter::setRate(double rate_A_per_us) {
  order_.rate_A_per_us = rate_A_per_us;
  judge();
}

void FieldImportPresenter::setSurface(const QString& file) {
  order_.surface = file.toStdString();
  judge();
}

void FieldImportPresenter::setT1(const QString& file) {
  order_.t1 = file.toStdString();
  judge();
}

void FieldImportPresenter::judge() {
  field_.reset();
  failure_.clear();
  is_outdated_ = true;
  if (order_.target.empty())
    failure_ = tr("a field belongs to the pose of one target: plan that target first");
  else if (needs_surface_ && order_.surface.empty())
    failure_ = tr("the file holds values alone: choose the GIFTI surface that they belong to");
  if (!failure_.isEmpty()) is_outdated_ = false;
  goOn();
  emit changed();
}

void FieldImportPresenter::goOn() {
  if (reader_.isRunning() || !std::exchange(is_outdated_, false)) return;
  reader_.start(tr("Reading the field"),
                [this, order = order_, store = model_.current().store](TaskMonitor&) -> TaskRunner::Delivery {
                  const auto field = steps::previewField(store, order);
                  return [this, field] {
                    if (is_outdated_ || isRefused()) return;
                    field_ = field;
                    emit changed();
                  };
                });
}

QString FieldImportPresenter::words() const {
  if (!failure_.isEmpty()) return failure_;
  if (!field_) return tr("reading \u2026");
  const auto& p = field_->peak_place.mm;
  const auto figure = [](double value, int places) { return QString::number(value, 'f', places); };
  QStringList lines{tr("maximum %1 V/m, 99.9th percentile %2 V/m at %3 A/\u00b5s, at %4 %5 %6 mm (RAS)")
                        .arg(field_->peak, 0, 'g', 3)
                        .arg(field_->percentile_99_9, 0, 'g', 3)
                        .arg(field_->rate_A_per_us)
                        .arg(figure(p.x(), 1), figure(p.y(), 1), figure(p.z(), 1)),
                    inWindowWords(field_->words)};
  for (const auto& note : field_->notes) lines << inWindowWords(note);
  return lines.join("\n");
}

void FieldImportPresenter::takeIn() {
  if (!canTakeIn()) return;
  const auto order = order_;
  reader_.start(tr("Taking in the field"),
                [this, order, store = model_.current().store](TaskMonitor&) -> TaskRunner::Delivery {
                  steps::importField(store, order);
                  return [this, order] {
                    const QString target = QString::fromStdString(order.target);
                    plan_.setActive(target);
                    plan_.showAgain();
                    emit takenIn(tr("the field is kept with '%1': menu Field, tier 3").arg(target));
                  };
                });
  emit changed();
}

}  // namespace facenav::ui
