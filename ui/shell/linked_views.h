#pragma once
// LinkedViews: three slice views and the 3-D view of one case, linked by one crosshair: two by two, or, with
// the slices along the coil, the 3-D view large above the others.

#include <QWidget>
#include <array>
#include <memory>

#include "plan/coil_slice_view.h"
#include "shell/case_model.h"
#include "shell/scene_view.h"
#include "shell/slice_view.h"

class QLabel;
class QVBoxLayout;

namespace facenav::ui {

class LinkedViews : public QWidget {
  Q_OBJECT

 public:
  explicit LinkedViews(QWidget* parent = nullptr);
  void show(const LoadedCase& loaded);
  void setTargets(const guidance::TreatmentPlan& plan, const std::string& active);
  void setMasksShown(bool are_shown);
  /// Shows these in place of the case's own contours; crosshair, zoom and window stay.
  void setContours(const std::vector<scene::SliceContour>& contours);
  /// Shows another brain in the 3-D view, after a correction.
  void setBrain(const LoadedCase& loaded);
  void setBrain(const surface::BrainModel& brain);
  /// Shows the phi-theta model beside the 3-D view, from the same viewpoint, both without skin. Null: hides
  /// it.
  void showModelBeside(const LoadedCase* loaded);
  /// Sets the widget below the 3-D view. Takes ownership.
  void setSceneFooter(QWidget* footer);
  /// Adds the slices along the coil's axis, in a column of their own.
  void addCoilSlices();
  void setOverlays(const std::vector<scene::Overlay>& overlays);
  /// Sets the coil of those slices; without one `words` give the reason.
  void setCoil(const std::optional<scene::SlicedCoil>& coil, const QString& words);
  void setCoilSlicesShown(bool are_shown);
  void setTool(SliceTool* tool);
  Point<Mri> crosshair() const;
  void refreshSlices();
  /// Resets zoom, pan and window of the slices; the crosshair stays.
  void resetSlices();
  void setCrosshair(const Point<Mri>& at);
  SceneView& sceneView() { return *scene_view_; }

 signals:
  void crosshairMoved();
  /// Double click on a slice, or click on brain or scalp.
  void chosen(double x_mm, double y_mm, double z_mm, bool is_scalp);

 private:
  void makeModelView();
  void arrange();
  std::array<SliceView*, 3> slices_;
  std::vector<CoilSliceView*> coil_slices_;
  SceneView *scene_view_, *model_view_ = nullptr;
  QWidget *scene_box_, *model_box_ = nullptr, *footer_ = nullptr;
  QLabel* model_foot_ = nullptr;
  QLabel* scene_title_;
  std::shared_ptr<const surface::BrainModel> beside_;
  QVBoxLayout* scene_column_;
  std::shared_ptr<scene::SliceScene> slice_scene_;
  std::vector<scene::SliceContour> contours_;
  bool are_masks_shown_ = true, are_coil_slices_shown_ = true;
};

}  // namespace facenav::ui
