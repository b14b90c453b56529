#pragma once
// MaskEditor: a mask that is being corrected, with its history. Edits are MaskChanges made by the tools
// (brush.h, lasso.h, ...). A stroke of many brush positions is one step of the history. The automatic mask is
// never changed.

#include <optional>
#include <string>
#include <vector>

#include "facenav/editing/mask_change.h"

namespace facenav::editing {

class MaskEditor {
 public:
  /// `edited`: the result of an earlier session. Throws Error unless the grids match, or if the grid has more
  /// than 2^32 voxels.
  explicit MaskEditor(volume::Mask automatic, std::optional<volume::Mask> edited = std::nullopt);

  const volume::Mask& mask() const { return mask_; }
  const volume::Mask& automatic() const { return automatic_; }
  bool isEdited() const;  // true if the mask differs from the automatic one

  /// Adds one step to the history; an empty change adds none. Discards the steps that were undone.
  void apply(const std::string& name, const MaskChange& change);
  /// All changes from here to endStroke() form one step.
  void beginStroke(const std::string& name);
  void endStroke();
  /// Restores the automatic mask, as a step that can be undone.
  void resetToAutomatic();

  /// Name of the step undone or redone; nullopt if there is none. lastChange() gives its voxels. An open
  /// stroke is ended first.
  std::optional<std::string> undo();
  std::optional<std::string> redo();
  bool canUndo() const { return done_ > 0 || !stroke_.empty(); }
  bool canRedo() const { return done_ < steps_.size(); }
  /// Names of the steps, oldest first; the steps from index done() on are undone.
  std::vector<std::string> steps() const;
  std::size_t done() const { return done_; }

  /// lastChange(): the voxels flipped by the last call, for views. revision(): increases with every change,
  /// for autosave.
  const MaskChange& lastChange() const { return last_; }
  std::uint64_t revision() const { return revision_; }
  /// Identifies the mask's content by its history: undo and redo return to the same state, a stroke that is
  /// open or new makes another one.
  std::uint64_t state() const;
  std::size_t historyBytes() const;

 private:
  struct Step {
    std::string name;
    PackedChange change;
    std::uint64_t state = 0;  // after the step
  };
  void flipNow(const MaskChange& change);
  void remember(const std::string& name, MaskChange change);

  volume::Mask automatic_, mask_;
  std::vector<Step> steps_;
  std::size_t done_ = 0;
  bool is_stroke_ = false;
  std::string stroke_name_;
  MaskChange stroke_, last_;
  std::uint64_t revision_ = 0, last_state_ = 0;
};

}  // namespace facenav::editing
