#include "presenters/case_model.h"

namespace facenav::ui {

std::shared_ptr<LoadedCase> loadCase(const std::filesystem::path& folder, TaskMonitor& monitor) {
  auto store = casefile::CaseStore::open(folder);
  auto loaded = std::make_shared<LoadedCase>(LoadedCase{store, {}, {}, {}, {}, {}, {}, {}, {}, {}});
  loaded->id = QString::fromStdString(store.caseId());
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
  loaded->alignment = store.alignment();
  return loaded;
}

void CaseModel::open(std::shared_ptr<LoadedCase> loaded) {
  case_ = std::move(loaded);
  emit opened();
}

void CaseModel::setPlan(const guidance::TreatmentPlan& plan) {
  case_->store.setTargets(plan);
  case_->plan = plan;
  emit planChanged();
}

void CaseModel::setAlignment(const casefile::StoredAlignment& alignment) {
  case_->alignment = alignment;
  emit alignmentChanged();
}

}  // namespace facenav::ui
