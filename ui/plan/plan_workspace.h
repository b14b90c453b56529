#pragma once
// Plan: linked slices; cortex and scalp with a transparent coil; the list of targets.

#include <QWidget>

#include "facenav/scene/field_layer.h"
#include "facenav/scene/overlay_layer.h"
#include "facenav/scene/site_layer.h"
#include "plan/best_pose_presenter.h"
#include "plan/cortex_presenter.h"
#include "plan/head_presenter.h"
#include "plan/overlay_presenter.h"
#include "plan/place_presenter.h"
#include "plan/plan_presenter.h"

class QHBoxLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QVBoxLayout;

namespace facenav::ui {

class LinkedViews;
class OfferPanel;
class OffersPresenter;
class PlacePanel;
class ShownTools;
class TargetList;
class TargetTools;

class PlanWorkspace : public QWidget {
  Q_OBJECT

 public:
  PlanWorkspace(PlanPresenter& presenter, PlacePresenter& place, CortexPresenter& cortex, CaseModel& model,
                QWidget* parent = nullptr);
  /// Ends what computes on all cores, for a treatment.
  void stopBuilding();

  /// Shows targets that another program offers, with a preview in the head.
  void showOffersOf(OffersPresenter& offers);
  /// Has models of the head's field that are older than its masks built again by this queue.
  void buildFieldsBy(PrepareQueue& queue) { field_->buildBy(queue); }

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  QWidget* makeTargetsPanel();
  QHBoxLayout* makeEdits(QWidget* parent);
  TargetTools* makeTools(QWidget* parent);
  QWidget* makeFieldView(QWidget* parent);
  void showOverlays();
  void showSites();
  void showField();
  void showSlices();
  QWidget* makeFields(QWidget* parent);
  void showFields();
  void addKeys();
  bool moveByKey(const QKeyEvent& event);
  void showFault(const QString& words);
  void showCase();
  void showPlan();
  void showCoils();
  void showBrain();
  void takeCortex();

  PlanPresenter& presenter_;
  PlacePresenter& place_;
  CortexPresenter& cortex_;
  CaseModel& model_;
  HeadPresenter* head_;
  OverlayPresenter* overlays_;
  FieldPresenter* field_;
  BestPosePresenter* best_pose_;
  std::shared_ptr<const scene::CortexPicture> shown_cortex_;
  LinkedViews* views_;
  std::unique_ptr<scene::OverlayLayer> overlay_layer_;
  std::unique_ptr<scene::SiteLayer> site_layer_;
  std::unique_ptr<scene::FieldLayer> field_layer_;
  ShownTools* shown_;
  PlacePanel* place_panel_;
  TargetList* targets_;
  QVBoxLayout* offer_place_;
  OfferPanel* offer_ = nullptr;
  QLabel *detail_, *hint_, *fault_;
  QLineEdit *search_, *note_;
  QString compared_with_;
  QPushButton *undo_, *redo_, *remove_;
  scene::BrainLook shown_look_ = scene::BrainLook::model;
  bool is_drawing_brain_ = false;
  double shown_peel_mm_ = -1.0;
  bool is_outdated_ = false;
};

}  // namespace facenav::ui
