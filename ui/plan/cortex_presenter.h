#pragma once
// CortexPresenter: how the open case's brain is drawn in 3-D: phi-theta model, detailed cortex at a peel
// depth, or the distance between the two. The cortex is computed in the background when first needed, and
// again when the brain is corrected.

#include <QObject>
#include <QSettings>
#include <memory>

#include "facenav/scene/navigation_scene.h"
#include "shell/case_model.h"
#include "shell/task_runner.h"

namespace facenav::ui {

class CortexPresenter : public QObject {
  Q_OBJECT

 public:
  explicit CortexPresenter(CaseModel& model, QObject* parent = nullptr);

  scene::BrainLook look() const { return look_; }
  /// Sets the look and remembers it. Starts computing the cortex if the look needs it.
  void setLook(scene::BrainLook look);
  /// Shows the distance map with the phi-theta model beside it.
  void setBesideModel();
  bool isBesideModel() const { return is_beside_model_; }
  /// Sets the last choice (QSettings).
  void restoreLook();
  double peel_mm() const { return peel_mm_; }
  /// Sets the peel depth, 0..40 mm.
  void setPeel_mm(double peel_mm);
  /// Null until it is computed.
  std::shared_ptr<const scene::CortexPicture> cortex() const { return cortex_; }
  /// True if the case has a brain that can be drawn in detail.
  bool isPossible() const;
  bool isMaking() const { return runner_.isRunning(); }
  /// "making the cortex 40 %", "median 0.1 mm, 95 % within 3.2 mm", a failure, or empty.
  QString words() const;
  /// Upper end of the colour map's scale.
  double scale_mm() const { return cortex_ ? cortex_->full_mm : 0.0; }

 signals:
  /// Look, depth or words changed.
  void changed();
  /// The cortex was replaced or removed.
  void cortexChanged();

 private:
  void forget();
  void choose(scene::BrainLook look, bool is_beside_model);
  void make();

  CaseModel& model_;
  QSettings settings_;  // a member: each destructor writes the file, which would slow a slider
  TaskRunner runner_;
  std::shared_ptr<const scene::CortexPicture> cortex_;
  scene::BrainLook look_ = scene::BrainLook::model;
  double peel_mm_ = 2.0;
  bool is_beside_model_ = false;
  int percent_ = 0, subject_ = 0;
  QString failure_;
};

}  // namespace facenav::ui
