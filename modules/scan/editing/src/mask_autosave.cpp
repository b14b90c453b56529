#include "facenav/editing/mask_autosave.h"

#include <chrono>

namespace facenav::editing {

MaskAutosave::MaskAutosave(Write write, double rest_s, double most_s)
    : write_(std::move(write)), rest_s_(rest_s), most_s_(most_s) {}

MaskAutosave::~MaskAutosave() {
  if (task_.valid()) task_.wait();
}

bool MaskAutosave::isSaved(const MaskEditor& editor) const { return written_ == editor.revision(); }

void MaskAutosave::begin(const MaskEditor& editor, double now_s) {
  being_written_ = editor.revision();
  last_write_s_ = now_s;
  task_ = std::async(std::launch::async, [write = write_, mask = editor.mask()] { write(mask); });
}

void MaskAutosave::finishWrite() {
  task_.get();
  written_ = being_written_;
}

void MaskAutosave::tick(const MaskEditor& editor, double now_s) {
  if (editor.revision() != seen_) {
    if (seen_ == written_) last_write_s_ = now_s;  // first change after everything was saved
    seen_ = editor.revision();
    changed_s_ = now_s;
  }
  if (task_.valid()) {
    if (task_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return;
    finishWrite();
  }
  if (isSaved(editor)) return;
  if (now_s - changed_s_ >= rest_s_ || now_s - last_write_s_ >= most_s_) begin(editor, now_s);
}

void MaskAutosave::saveNow(const MaskEditor& editor) {
  if (task_.valid()) finishWrite();
  if (isSaved(editor)) return;
  begin(editor, last_write_s_);
  finishWrite();
}

}  // namespace facenav::editing
