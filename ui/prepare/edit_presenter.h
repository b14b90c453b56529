#pragma once
// EditPresenter: correction of the brain mask by hand: state of the tools, strokes from a slice view, undo,
// autosave of a draft, and saving (which voids a sign-off). The geometry is in module editing.

#include <QObject>
#include <QTimer>
#include <set>

#include "facenav/editing/lasso.h"
#include "facenav/editing/mask_autosave.h"
#include "facenav/editing/scalpel.h"
#include "shell/case_model.h"
#include "shell/slice_tool.h"
#include "shell/task_runner.h"

namespace facenav::ui {

/// `scalpel` works on the 3-D view, the others on slices.
enum class EditTool { none, brush, eraser, threshold, lasso, grow, scalpel };

class EditPresenter : public QObject, public SliceTool {
  Q_OBJECT

 public:
  EditPresenter(CaseModel& model, TaskRunner& tasks, QObject* parent = nullptr);
  ~EditPresenter() override;

  /// True if an open case has a brain mask, or a grid for one.
  bool canEdit() const { return editor_ != nullptr; }
  EditTool tool() const { return tool_; }
  void setTool(EditTool tool);
  double radius_mm() const { return radius_mm_; }
  void setRadius_mm(double radius_mm);
  /// Sets the brush: a ball, or a disc in the shown slice.
  void setBall(bool is_ball);

  double cutDepth_mm() const { return cut_depth_mm_; }
  /// Depth of the scalpel's cut below the visible surface.
  void setCutDepth_mm(double depth_mm);
  /// Removes what lies behind a line drawn on the 3-D view.
  void cut(const editing::ScalpelView& view, const editing::Outline& outline);
  void smooth();
  void fillHoles();
  /// Interpolates between the slices drawn on, in the orientation used last.
  void interpolate();
  void resetToAutomatic();
  void undo();
  void redo();
  bool canUndo() const { return editor_ && editor_->canUndo(); }
  bool canRedo() const { return editor_ && editor_->canRedo(); }
  /// True if the mask differs from the case's, or a draft is not saved.
  bool hasUnsaved() const;
  /// Saves into the case and models the brain again, on a worker thread.
  void save();
  /// Discards the draft and returns to the case's own mask.
  void discard();

  /// The mask being corrected; null if there is none.
  std::shared_ptr<const volume::Mask> mask() const;
  std::shared_ptr<const volume::Mask> automatic() const;
  /// "brush 5.0 mm   brain 1 412 ml   +120 -40 voxels": for the panel.
  QString words() const;

  // SliceTool
  bool isActive() const override {
    return canEdit() && tool_ != EditTool::none && tool_ != EditTool::scalpel;
  }
  void press(const volume::SlicePlane& plane, const Eigen::Vector2d& at_px, bool is_inverse) override;
  void drag(const volume::SlicePlane& plane, const Eigen::Vector2d& at_px) override;
  void release(const volume::SlicePlane& plane) override;
  double cursorRadius_mm() const override;
  const std::vector<Eigen::Vector2d>& outline() const override { return outline_; }
  void resize(int steps) override;

 signals:
  /// Tool, size, history or saved state changed.
  void changed();
  /// The mask's voxels changed. `is_stroke`: more changes follow at once.
  void maskChanged(bool is_stroke);
  /// The brain's model of the current mask, for the 3-D view; a second or two after an edit.
  void brainFollowed(const std::shared_ptr<const surface::BrainModel>& brain);
  void refused(const QString& words);

 private:
  void open();
  void keepDraft();
  void noteSaved(std::uint64_t state);
  std::unique_ptr<editing::MaskAutosave> makeAutosave() const;
  void dab(const volume::SlicePlane& plane, const Eigen::Vector2d& from_px, const Eigen::Vector2d& to_px);
  void finish(const QString& name, const editing::MaskChange& change);
  void noteSlice(const volume::SlicePlane& plane);
  void autosave();
  void dropNeedlessDraft();
  void follow();
  void tellDraft();
  template <class Action>
  void guarded(Action action);

  CaseModel& model_;
  TaskRunner& tasks_;
  std::shared_ptr<editing::MaskEditor> editor_;
  std::unique_ptr<editing::MaskAutosave> autosave_;  // of the case that the editor works on
  std::uint64_t saved_state_ = 0;
  bool has_draft_ = false;         // of an earlier session
  bool is_draft_written_ = false;  // in this one
  EditTool tool_ = EditTool::none;
  double radius_mm_ = 5.0, cut_depth_mm_ = 10.0;
  bool is_ball_ = false, is_inverse_ = false;
  std::vector<Eigen::Vector2d> outline_;
  Eigen::Vector2d last_px_ = Eigen::Vector2d::Zero();
  editing::ValueRange range_{0, 0};
  int drawn_axis_ = -1;
  std::set<int> drawn_slices_;
  QTimer autosave_timer_, follow_timer_;
  TaskRunner follower_;
  std::uint64_t followed_revision_ = 0;
};

}  // namespace facenav::ui
