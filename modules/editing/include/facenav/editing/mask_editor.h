#pragma once
// MaskEditor: one mask under correction, with its history. Edits are MaskChanges made by the tools (brush.h,
// lasso.h, ...); a stroke of many dabs is one step of the history. The automatic mask stays as it was.

#include <optional>
#include <string>
#include <vector>

#include "facenav/editing/mask_change.h"

namespace facenav::editing {

class MaskEditor {
 public:
  /// `edited`: where an earlier session left off. Throws Error unless the grids match, or the grid has more
  /// than 2^32 voxels.
  explicit MaskEditor(volume::Mask automatic, std::optional<volume::Mask> edited = std::nullopt);

  const volume::Mask& mask() const { return mask_; }
  const volume::Mask& automatic() const { return automatic_; }
  bool isEdited() const;  // the mask differs from the automatic one

  /// One step of the history; an empty change is none. Forgets what was undone.
  void apply(const std::string& name, const MaskChange& change);
  /// From here to endStroke() all changes are one step.
  void beginStroke(const std::string& name);
  void endStroke();
  /// As a step that can be undone.
  void resetToAutomatic();

  /// Name of the step undone or redone; nothing where there is none. What changed is in lastChange(). A
  /// stroke that is still open is ended first.
  std::optional<std::string> undo();
  std::optional<std::string> redo();
  bool canUndo() const { return done_ > 0 || !stroke_.empty(); }
  bool canRedo() const { return done_ < steps_.size(); }
  /// Names of the steps, the oldest first; those from done() on were undone.
  std::vector<std::string> steps() const;
  std::size_t done() const { return done_; }

  /// For views: what the last call flipped. Counts up with every change: for autosave.
  const MaskChange& lastChange() const { return last_; }
  std::uint64_t revision() const { return revision_; }
  std::size_t historyBytes() const;

 private:
  struct Step {
    std::string name;
    PackedChange change;
  };
  void flipNow(const MaskChange& change);
  void remember(const std::string& name, MaskChange change);

  volume::Mask automatic_, mask_;
  std::vector<Step> steps_;
  std::size_t done_ = 0;
  bool is_stroke_ = false;
  std::string stroke_name_;
  MaskChange stroke_, last_;
  std::uint64_t revision_ = 0;
};

}  // namespace facenav::editing
