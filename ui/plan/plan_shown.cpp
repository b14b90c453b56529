// What Plan shows of the plan: the active target, or a target that another program offers.

#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include "plan/other_words.h"
#include "plan/plan_workspace.h"
#include "shell/linked_views.h"
#include "treat/offer_panel.h"

namespace facenav::ui {

void PlanWorkspace::showOffersOf(OffersPresenter& offers) {
  offer_ = new OfferPanel(offers, OfferPanel::Page::plan, this);
  offer_place_->addWidget(offer_);
  connect(offer_, &OfferPanel::previewChanged, this, [this] {
    showCoils();
    if (offer_->previewed()) views_->sceneView().scene().setView(scene::ViewPreset::target);
    views_->sceneView().refresh();
  });
  connect(&offers, &OffersPresenter::shown, offer_, &OfferPanel::showOffer);
}

void PlanWorkspace::showPlan() {
  showFault({});
  const auto* active = presenter_.active();
  detail_->setText(active ? place_.describe(active->cortex_point) + "\n" + presenter_.depthWords(*active)
                          : tr("no target chosen"));
  const QString compared = presenter_.compareWords(compared_with_);
  if (!compared.isEmpty()) detail_->setText(detail_->text() + "\n" + compared);
  showFields();
  undo_->setEnabled(presenter_.canUndo());
  redo_->setEnabled(presenter_.canRedo());
  remove_->setEnabled(active && !active->is_locked);
  showCoils();
}

/// Draws targets and coil in the views: those of the plan, or an offered target in place of the active one.
void PlanWorkspace::showCoils() {
  if (is_outdated_ || !model_.isOpen()) return;
  auto plan = presenter_.plan();
  std::optional<guidance::Target> shown;
  auto sliced = presenter_.slicedCoil();
  if (offer_ && offer_->previewed()) {
    const auto& offer = *offer_->previewed();
    shown = shownTarget(offer.name.toStdString(), offer.mri_T_coil);
    plan.targets.push_back(*shown);
    sliced = scene::SlicedCoil{offer.mri_T_coil, model_.current().coil.plate, std::nullopt};
  } else if (const auto* active = presenter_.active()) {
    shown = *active;
  }
  views_->sceneView().scene().setCoilGhost(shown ? std::optional(shown->mri_T_target) : std::nullopt);
  views_->setTargets(plan, shown ? shown->name : std::string());
  views_->setCoil(sliced, tr("no target chosen"));
  if (shown) views_->setCrosshair(shown->cortex_point);
}

}  // namespace facenav::ui
