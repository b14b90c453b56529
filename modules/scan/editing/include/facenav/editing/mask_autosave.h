#pragma once
// MaskAutosave: regularly writes the edited mask on its own thread. A crash costs only some seconds of work,
// and the window never waits for the disk.

#include <functional>
#include <future>

#include "facenav/editing/mask_editor.h"

namespace facenav::editing {

class MaskAutosave {
 public:
  /// Writes a file completely or not at all. Called on another thread, one call at a time.
  using Write = std::function<void(const volume::Mask&)>;
  /// Saves `rest_s` after the last change, or `most_s` after the last write if changes go on without a pause.
  explicit MaskAutosave(Write write, double rest_s = 2, double most_s = 15);
  /// Waits for a running write; does not start one.
  ~MaskAutosave();

  /// Call it regularly (from a timer) with a steady clock. Starts a write when one is due and none is
  /// running. Throws the exception of a failed write once; the change stays unsaved and is written again
  /// later.
  void tick(const MaskEditor& editor, double now_s);
  /// Writes all unsaved changes and waits. Throws if the write throws.
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
