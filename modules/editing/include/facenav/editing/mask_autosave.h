#pragma once
// MaskAutosave: writes the mask under correction now and then, on a thread of its own, so that a crash costs
// some seconds of work and the window never waits for the disk.

#include <functional>
#include <future>

#include "facenav/editing/mask_editor.h"

namespace facenav::editing {

class MaskAutosave {
 public:
  /// Writes a whole file; called on another thread, one call at a time.
  using Write = std::function<void(const volume::Mask&)>;
  /// `rest_s`: since the last change; `most_s`: since the last file, where changes go on and on.
  explicit MaskAutosave(Write write, double rest_s = 2, double most_s = 15);
  /// Waits for a write under way; does not begin one.
  ~MaskAutosave();

  /// Call it now and then (a timer) with a steady clock. Begins a write where one is due and none is under
  /// way. Throws what the last write threw, once; the change then stays unsaved and is tried again.
  void tick(const MaskEditor& editor, double now_s);
  /// Writes what is not written yet, and waits. Throws what the write throws.
  void saveNow(const MaskEditor& editor);
  bool isSaved(const MaskEditor& editor) const;

 private:
  void begin(const MaskEditor& editor, double now_s);
  void finishWrite();

  Write write_;
  double rest_s_, most_s_;
  std::uint64_t seen_ = 0, written_ = 0, being_written_ = 0;
  double changed_s_ = 0, last_write_s_ = 0;
  std::future<void> task_;
};

}  // namespace facenav::editing
