#include "prepare/edit_presenter.h"

#include <algorithm>
#include <cmath>

#include "facenav/casefile/edited_brain.h"
#include "facenav/core/error.h"
#include "facenav/core/log.h"
#include "facenav/core/timestamp.h"
#include "facenav/editing/region_grow.h"
#include "facenav/editing/slice_interpolation.h"
#include "facenav/editing/whole_mask_tools.h"
#include "facenav/prepare/correct_brain.h"
#include "shell/shown_words.h"

namespace facenav::ui {
namespace {

constexpr double kLeastRadius_mm = 0.5, kMostRadius_mm = 40.0, kSizeStep = 1.15;
constexpr int kAutosave_ms = 500, kFollow_ms = 400;

Direction<Mri> normalOf(const volume::SlicePlane& plane) {
  return Direction<Mri>(plane.right.v.cross(plane.down.v));
}

}  // namespace

EditPresenter::EditPresenter(CaseModel& model, TaskRunner& tasks, QObject* parent)
    : QObject(parent), model_(model), tasks_(tasks) {
  connect(&model_, &CaseModel::opened, this, &EditPresenter::open);
  connect(this, &EditPresenter::changed, this, &EditPresenter::tellDraft);
  connect(this, &EditPresenter::maskChanged, this, &EditPresenter::tellDraft);
  autosave_timer_.setInterval(kAutosave_ms);
  connect(&autosave_timer_, &QTimer::timeout, this, &EditPresenter::autosave);
  autosave_timer_.start();
  follow_timer_.setSingleShot(true);
  follow_timer_.setInterval(kFollow_ms);
  connect(&follow_timer_, &QTimer::timeout, this, &EditPresenter::follow);
  connect(this, &EditPresenter::maskChanged, &follow_timer_, QOverload<>::of(&QTimer::start));
}

EditPresenter::~EditPresenter() { keepDraft(); }

/// Writes what the autosave has not written yet. Called before the window or the case closes, and before a
/// save.
void EditPresenter::keepDraft() {
  try {
    if (!editor_ || !autosave_ || editor_->state() == saved_state_) return;
    is_draft_written_ = true;
    autosave_->saveNow(*editor_);
  } catch (const std::exception& error) {  // the last autosave remains
    logWarning(std::string("the corrected brain's draft was not kept: ") + error.what());
  }
}

template <class Action>
void EditPresenter::guarded(Action action) {
  if (!canEdit()) return;
  try {
    action();
  } catch (const Error& error) {
    emit refused(shownWords(error));
  }
}

std::unique_ptr<editing::MaskAutosave> EditPresenter::makeAutosave() const {
  return std::make_unique<editing::MaskAutosave>(
      [store = model_.current().store](const volume::Mask& mask) { casefile::saveBrainDraft(store, mask); });
}

void EditPresenter::open() {
  keepDraft();
  const auto& c = model_.current();
  autosave_.reset();
  editor_.reset();
  drawn_axis_ = -1;
  drawn_slices_.clear();
  outline_.clear();
  tool_ = EditTool::none;
  try {
    const auto correction = steps::beginCorrection(c.store, c.mri->grid, c.brain_mask.get());
    editor_ = correction.editor;
    has_draft_ = correction.has_draft;
    saved_state_ = editor_->state();
    is_draft_written_ = false;
    followed_revision_ = has_draft_ ? ~editor_->revision() : editor_->revision();
    autosave_ = makeAutosave();
  } catch (const Error& error) {
    editor_.reset();
    emit refused(shownWords(error));
  }
  emit changed();
  emit maskChanged(false);
}

/// Passes the unsaved correction to the model: a sign-off is not valid beside it.
void EditPresenter::tellDraft() {
  dropNeedlessDraft();
  if (editor_ && model_.isOpen()) model_.setDraft(hasUnsaved() ? mask() : nullptr);
}

void EditPresenter::setTool(EditTool tool) {
  tool_ = tool == tool_ ? EditTool::none : tool;
  outline_.clear();
  emit changed();
}

void EditPresenter::setRadius_mm(double radius_mm) {
  radius_mm_ = std::clamp(radius_mm, kLeastRadius_mm, kMostRadius_mm);
  emit changed();
}

void EditPresenter::setBall(bool is_ball) {
  is_ball_ = is_ball;
  emit changed();
}

void EditPresenter::resize(int steps) { setRadius_mm(radius_mm_ * std::pow(kSizeStep, steps)); }

double EditPresenter::cursorRadius_mm() const {
  const bool is_round = tool_ == EditTool::brush || tool_ == EditTool::eraser || tool_ == EditTool::threshold;
  return is_round ? radius_mm_ : 0.0;
}

std::shared_ptr<const volume::Mask> EditPresenter::mask() const {
  return editor_ ? std::shared_ptr<const volume::Mask>(editor_, &editor_->mask()) : nullptr;
}

std::shared_ptr<const volume::Mask> EditPresenter::automatic() const {
  return editor_ ? std::shared_ptr<const volume::Mask>(editor_, &editor_->automatic()) : nullptr;
}

void EditPresenter::press(const volume::SlicePlane& plane, const Eigen::Vector2d& at_px, bool is_inverse) {
  guarded([&] {
    is_inverse_ = is_inverse;
    last_px_ = at_px;
    const auto place = plane.toMri(at_px.x(), at_px.y());
    const auto& mri = *model_.current().mri;
    if (tool_ == EditTool::lasso) {
      outline_ = {at_px};
    } else if (tool_ == EditTool::grow) {
      finish(tr("region grow"),
             editing::growRegion(editor_->mask(), mri, place, editing::rangeAround(mri, place),
                                 steps::kGrowReach_mm, !is_inverse));
    } else {
      if (tool_ == EditTool::threshold) range_ = editing::rangeAround(mri, place);
      editor_->beginStroke((tool_ == EditTool::eraser      ? tr("eraser")
                            : tool_ == EditTool::threshold ? tr("threshold paint")
                                                           : tr("brush"))
                               .toStdString());
      dab(plane, at_px, at_px);
    }
  });
}

void EditPresenter::dab(const volume::SlicePlane& plane, const Eigen::Vector2d& from_px,
                        const Eigen::Vector2d& to_px) {
  const editing::BrushPath path{plane.toMri(from_px.x(), from_px.y()), plane.toMri(to_px.x(), to_px.y())};
  editing::Brush brush{radius_mm_, std::nullopt};
  if (!is_ball_) brush.slice_normal = normalOf(plane);
  const bool is_brain = (tool_ != EditTool::eraser) != is_inverse_;
  const auto change =
      tool_ == EditTool::threshold
          ? editing::paintWithin(editor_->mask(), *model_.current().mri, range_, path, brush, is_brain)
          : editing::paint(editor_->mask(), path, brush, is_brain);
  editor_->apply("", change);
  emit maskChanged(true);
}

void EditPresenter::drag(const volume::SlicePlane& plane, const Eigen::Vector2d& at_px) {
  guarded([&] {
    if (tool_ == EditTool::lasso) {
      outline_.push_back(at_px);
    } else if (tool_ != EditTool::grow) {
      dab(plane, last_px_, at_px);
    }
    last_px_ = at_px;
  });
}

void EditPresenter::release(const volume::SlicePlane& plane) {
  guarded([&] {
    if (tool_ == EditTool::lasso) {
      const auto outline = std::exchange(outline_, {});
      if (outline.size() > 2)
        finish(is_inverse_ ? tr("lasso, cut") : tr("lasso"),
               editing::lasso(editor_->mask(), plane, outline, !is_inverse_));
    } else if (tool_ != EditTool::grow) {
      editor_->endStroke();
      emit changed();
      emit maskChanged(false);
    }
    if (tool_ != EditTool::grow && !is_ball_) noteSlice(plane);
  });
}

/// Remembers the slices drawn on by hand in one orientation; interpolation runs between them.
void EditPresenter::noteSlice(const volume::SlicePlane& plane) {
  const auto& grid = editor_->mask().grid;
  const int axis = volume::sliceAxis(grid, normalOf(plane));
  const int slice = int(std::lround(grid.toVoxel(plane.toMri(last_px_.x(), last_px_.y()))[axis]));
  if (axis != drawn_axis_) drawn_slices_.clear();
  drawn_axis_ = axis;
  if (slice >= 0 && slice < grid.size[std::size_t(axis)]) drawn_slices_.insert(slice);
  emit changed();
}

void EditPresenter::finish(const QString& name, const editing::MaskChange& change) {
  editor_->apply(name.toStdString(), change);
  emit changed();
  emit maskChanged(false);
}

void EditPresenter::setCutDepth_mm(double depth_mm) {
  cut_depth_mm_ = std::clamp(depth_mm, kLeastRadius_mm, kMostRadius_mm);
  emit changed();
}

void EditPresenter::cut(const editing::ScalpelView& view, const editing::Outline& outline) {
  guarded([&] { finish(tr("scalpel"), editing::cut(editor_->mask(), view, outline, cut_depth_mm_)); });
}

/// Updates the 3-D view: computes the brain's model of the current mask in the background, after a pause in
/// editing.
void EditPresenter::follow() {
  if (!editor_ || editor_->revision() == followed_revision_) return;
  if (follower_.isRunning()) return follow_timer_.start();
  const auto revision = editor_->revision();
  follower_.start(tr("The brain's model"),
                  [this, revision, mask = editor_->mask(), mri = model_.current().mri,
                   folder = model_.current().store.folder()](TaskMonitor& monitor) -> TaskRunner::Delivery {
                    auto brain = std::make_shared<const surface::BrainModel>(
                        surface::buildBrainModel(*mri, mask, {}, monitor));
                    return [this, revision, brain, folder] {
                      if (!editor_ || model_.current().store.folder() != folder) return;
                      followed_revision_ = revision;
                      emit brainFollowed(brain);
                      if (editor_->revision() != revision) follow_timer_.start();
                    };
                  });
}

void EditPresenter::smooth() {
  guarded([&] { finish(tr("smooth"), editing::smooth(editor_->mask(), steps::kSmooth_mm)); });
}

void EditPresenter::fillHoles() {
  guarded([&] { finish(tr("fill holes"), editing::fillHoles(editor_->mask())); });
}

void EditPresenter::interpolate() {
  guarded([&] {
    if (drawn_slices_.size() < 2)
      return void(emit refused(tr("draw on two or more slices of one orientation first, as discs")));
    finish(tr("interpolate"), editing::interpolateSlices(editor_->mask(), drawn_axis_,
                                                         {drawn_slices_.begin(), drawn_slices_.end()}));
    drawn_slices_.clear();
  });
}

void EditPresenter::resetToAutomatic() {
  guarded([&] {
    editor_->resetToAutomatic();
    emit changed();
    emit maskChanged(false);
  });
}

void EditPresenter::undo() {
  if (!editor_ || !editor_->undo()) return;
  emit changed();
  emit maskChanged(false);
}

void EditPresenter::redo() {
  if (!editor_ || !editor_->redo()) return;
  emit changed();
  emit maskChanged(false);
}

bool EditPresenter::hasUnsaved() const { return editor_ && (has_draft_ || editor_->state() != saved_state_); }

void EditPresenter::autosave() {
  if (!editor_ || editor_->state() == saved_state_ || tasks_.isRunning()) return;
  guarded([&] {
    is_draft_written_ = true;
    autosave_->tick(*editor_, Timestamp::now().s);
  });
}

/// Removes the draft when every stroke of this session was undone: nothing is unsaved then.
void EditPresenter::dropNeedlessDraft() {
  if (!editor_ || !is_draft_written_ || hasUnsaved() || tasks_.isRunning()) return;
  try {
    autosave_ = makeAutosave();  // waits for a write that runs
    casefile::removeBrainDraft(model_.current().store);
    is_draft_written_ = false;
  } catch (const Error& error) {
    logWarning(std::string("a draft that is not needed was not removed: ") + error.what());
  }
}

void EditPresenter::save() {
  if (!hasUnsaved() || tasks_.isRunning()) return;
  editor_->endStroke();
  keepDraft();  // the save takes seconds, and the window may close before its end
  const auto state = editor_->state();
  tasks_.start(tr("Saving the corrected brain"),
               [this, state, editor = editor_, mask = editor_->mask(), mri = model_.current().mri,
                store = model_.current().store](TaskMonitor& monitor) -> TaskRunner::Delivery {
                 auto surfaces = steps::saveCorrection(store, *mri, mask, monitor);
                 auto brain = std::make_shared<surface::BrainModel>(std::move(surfaces.model));
                 const auto shown = casefile::seenFiles(store);
                 const auto status = casefile::signOffStatus(store);
                 auto saved = std::make_shared<volume::Mask>(mask);
                 return [this, state, editor, brain, saved, shown, status, folder = store.folder()] {
                   if (!model_.isOpen() || model_.current().store.folder() != folder) return;
                   if (editor == editor_) noteSaved(state);
                   auto now = status;  // a sign-off is not valid beside a newer stroke
                   now.has_draft = hasUnsaved();
                   model_.setBrain(saved, brain, shown, now);
                   emit changed();
                 };
               });
}

/// Removes the draft, unless strokes came after the saved state: then it is kept.
void EditPresenter::noteSaved(std::uint64_t state) {
  saved_state_ = state;
  has_draft_ = false;
  if (editor_->state() == state) casefile::removeBrainDraft(model_.current().store);
}

void EditPresenter::discard() {
  guarded([&] {
    autosave_.reset();
    casefile::removeBrainDraft(model_.current().store);
    open();
  });
}

QString EditPresenter::words() const {
  if (!editor_) return tr("no case open");
  QString words = tr("brain %1 ml").arg(std::lround(editor_->mask().volume_ml()));
  if (hasUnsaved()) words += tr("   not saved (a draft is kept)");
  if (drawn_slices_.size() > 1) words += tr("   %1 slices drawn on").arg(drawn_slices_.size());
  return words;
}

}  // namespace facenav::ui
