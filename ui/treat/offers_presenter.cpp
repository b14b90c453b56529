#include "treat/offers_presenter.h"

#include "facenav/core/error.h"
#include "plan/other_words.h"
#include "shell/author.h"

namespace facenav::ui {
OffersPresenter::OffersPresenter(CaseModel& model, QObject* parent) : QObject(parent), model_(model) {}

std::vector<OfferedPose> OffersPresenter::all() const {
  std::vector<OfferedPose> offers;
  for (const auto& [name, offer] : orders_.offers()) {
    if (!offer.refusal().empty()) continue;
    const auto& item = offer.preview.items.front().item;
    QString words =
        tr("from %1, at %2 (RAS, mm)").arg(QString::fromStdString(offer.from), importedPlaceWords(item));
    for (const auto& note : item.notes) words += "; " + inWindowWords(note);
    offers.push_back({QString::fromStdString(name), words, *item.mri_T_coil});
  }
  return offers;
}

void OffersPresenter::take(const QString& name) {
  if (!model_.isOpen()) return;
  is_taking_ = true;
  QString failure;
  try {
    orders_.take(
        name.toStdString(), model_.current().store, recordedAuthor(),
        [&](const guidance::TreatmentPlan& plan) { keep_ ? keep_(plan, name) : model_.setPlan(plan); });
  } catch (const std::exception& error) {  // includes errors of the file system
    failure = inWindowWords(error.what());
  }
  is_taking_ = false;
  if (failure.isEmpty())
    emit decided(QStringLiteral("target taken"), name);
  else
    emit refused(failure);
  emit changed();
}

void OffersPresenter::refuse(const QString& name) {
  orders_.refuse(name.toStdString());
  emit decided(QStringLiteral("target refused"), name);
  emit changed();
}

void OffersPresenter::forget() {
  orders_.forget();
  emit changed();
}

}  // namespace facenav::ui
