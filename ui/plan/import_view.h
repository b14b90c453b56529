#pragma once
// ImportView: the head with the coils of other programs' files at their places, before they are taken in.
// The chosen one is drawn as a coil; a click on the head chooses the nearest.

#include <QWidget>

#include "facenav/scene/pulse_layer.h"
#include "facenav/scene/site_layer.h"
#include "plan/import_list.h"
#include "shell/scene_view.h"

namespace facenav::ui {

class ImportView : public QWidget {
  Q_OBJECT

 public:
  ImportView(ImportPresenter& presenter, CaseModel& model, QWidget* parent = nullptr);
  ~ImportView() override;
  /// Marks this row's coils: those of an item, of a session or of a file.
  void setChosen(const ImportRow& row);
  SceneView& sceneView() { return *view_; }

 signals:
  void picked(const facenav::ui::ImportRow& row);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void draw();
  void pickNear(const Point<Mri>& point);
  void showChosen();

  ImportPresenter& presenter_;
  CaseModel& model_;
  SceneView* view_;
  std::unique_ptr<scene::PulseLayer> coils_;
  std::unique_ptr<scene::SiteLayer> names_;
  ImportRow chosen_;
  bool has_case_ = false;
};

}  // namespace facenav::ui
