#include "shell/case_model.h"
#include "shell/language.h"

#include <QDateTime>
#include <QLocale>

namespace facenav::ui {

std::shared_ptr<LoadedCase> loadCase(const std::filesystem::path& folder, TaskMonitor& monitor) {
  auto store = casefile::CaseStore::open(folder);
  auto loaded =
      std::make_shared<LoadedCase>(LoadedCase{store, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}});
  loaded->id = QString::fromStdString(store.caseId());
  loaded->label = QString::fromStdString(store.label());
  loaded->shown_sha256 = casefile::seenFiles(store);  // before reading, so that no later change is missed
  monitor.report("opening the MRI", 0.1);
  loaded->mri = std::make_shared<volume::Volume>(store.mri());
  monitor.report("opening masks", 0.5);
  loaded->head_mask = std::make_shared<volume::Mask>(store.headMask());
  if (auto mask = store.brainMask()) loaded->brain_mask = std::make_shared<volume::Mask>(std::move(*mask));
  monitor.report("opening surfaces", 0.8);
  loaded->scalp = std::make_shared<surface::ScalpSurface>(store.scalp());
  if (auto brain = store.brain()) loaded->brain = std::make_shared<surface::BrainModel>(std::move(*brain));
  loaded->findings = store.findings();
  loaded->plan = store.targets();
  for (const auto& fault : loaded->plan.damaged) loaded->findings.push_back(fault);
  loaded->atlas = store.atlas();
  loaded->coil = casefile::coilOf(folder);
  loaded->sign_off = casefile::signOffStatus(store);
  return loaded;
}

void CaseModel::open(std::shared_ptr<LoadedCase> loaded) {
  case_ = std::move(loaded);
  override_.reset();
  emit opened();
}

void CaseModel::setPlan(const guidance::TreatmentPlan& plan) {
  case_->store.setTargets(plan);
  case_->plan = plan;
  emit planChanged();
}

void CaseModel::setCoil(const std::filesystem::path& coil_json) {
  casefile::setCoil(case_->store.folder(), coil_json);
  case_->coil = casefile::coilOf(case_->store.folder());
  emit planChanged();
}

void CaseModel::setLabel(const QString& label) {
  case_->label = label;
  emit labelChanged();
}

void CaseModel::setSignOff(const casefile::SignOffStatus& status) {
  case_->sign_off = status;
  emit signOffChanged();
}

void CaseModel::setBrain(std::shared_ptr<const volume::Mask> mask,
                         std::shared_ptr<const surface::BrainModel> brain,
                         const std::map<std::string, std::string>& shown,
                         const casefile::SignOffStatus& status) {
  case_->brain_mask = std::move(mask);
  case_->brain = std::move(brain);
  case_->shown_sha256 = shown;
  case_->sign_off = status;
  emit brainChanged();
  emit signOffChanged();
}

void CaseModel::setDraft(std::shared_ptr<const volume::Mask> draft) {
  const bool has_draft = draft != nullptr;
  const bool is_new = has_draft != case_->sign_off.has_draft || has_draft != (case_->draft != nullptr);
  case_->draft = std::move(draft);
  case_->sign_off.has_draft = has_draft;
  if (!is_new) return;
  emit draftChanged();
  emit signOffChanged();
}

void CaseModel::setOverride(const Override& given) {
  override_ = given;
  emit signOffChanged();
}

QString dayInWords(const std::string& utc) {
  QDateTime time = QDateTime::fromString(QString::fromStdString(utc), "yyyyMMdd'T'HHmmss'Z'");
  time.setTimeSpec(Qt::UTC);
  if (!time.isValid()) return QString::fromStdString(utc);
  const QDate day = time.toLocalTime().date();
  const QLocale locale = languageInForce() == "en" ? QLocale::c() : QLocale(languageInForce());
  return locale.toString(
      day, day.year() == QDate::currentDate().year() ? CaseModel::tr("d MMM") : CaseModel::tr("d MMM yyyy"));
}

QString signOffWords(const casefile::SignOffStatus& status) {
  if (const auto& rejection = status.rejection)
    return CaseModel::tr("scan rejected %1 by %2: %3")
        .arg(dayInWords(rejection->utc), QString::fromStdString(rejection->by),
             QString::fromStdString(rejection->reason));
  const QString not_saved = CaseModel::tr("a correction of the brain is not saved");
  if (!status.last)
    return status.has_draft ? CaseModel::tr("not signed off, %1").arg(not_saved)
                            : CaseModel::tr("not signed off");
  const QString by = QString::fromStdString(status.last->by);
  if (status.holds()) return CaseModel::tr("checked %1 by %2").arg(dayInWords(status.last->utc), by);
  QStringList names;
  for (const auto& name : status.changed) names << QString::fromStdString(name);
  if (status.has_draft) return CaseModel::tr("sign-off of %1 void: %2").arg(by, not_saved);
  return CaseModel::tr("sign-off of %1 void: %2 changed").arg(by, names.join(", "));
}

}  // namespace facenav::ui
