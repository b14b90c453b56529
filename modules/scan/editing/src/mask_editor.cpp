#include "facenav/editing/mask_editor.h"

#include <algorithm>
#include <limits>

#include "facenav/core/error.h"

namespace facenav::editing {

MaskEditor::MaskEditor(volume::Mask automatic, std::optional<volume::Mask> edited)
    : automatic_(std::move(automatic)), mask_(edited ? std::move(*edited) : automatic_) {
  if (automatic_.voxels.size() > std::numeric_limits<std::uint32_t>::max())
    throw Error("the mask has too many voxels to be edited", {}, "resample it");
  if (!mask_.grid.matches(automatic_.grid))
    throw Error("the edited mask lies on another grid than the automatic one", {}, "prepare the case again");
  for (auto& voxel : mask_.voxels) voxel = voxel != 0;  // flipping needs values 0 and 1
}

bool MaskEditor::isEdited() const {
  for (std::size_t v = 0; v < mask_.voxels.size(); ++v)
    if ((mask_.voxels[v] != 0) != (automatic_.voxels[v] != 0)) return true;
  return false;
}

void MaskEditor::flipNow(const MaskChange& change) {
  flip(mask_, change);
  last_ = change;
  ++revision_;
}

void MaskEditor::remember(const std::string& name, MaskChange change) {
  if (change.empty()) return;
  steps_.resize(done_);
  steps_.push_back({name, pack(std::move(change)), ++last_state_});
  done_ = steps_.size();
}

void MaskEditor::apply(const std::string& name, const MaskChange& change) {
  if (change.empty()) return void(last_.voxels.clear());
  flipNow(change);
  if (!is_stroke_) return remember(name, change);
  stroke_.voxels.insert(stroke_.voxels.end(), change.voxels.begin(), change.voxels.end());
}

void MaskEditor::beginStroke(const std::string& name) {
  endStroke();
  is_stroke_ = true;
  stroke_name_ = name;
}

void MaskEditor::endStroke() {
  if (!is_stroke_) return;
  is_stroke_ = false;
  // A voxel that flipped twice is unchanged.
  auto& all = stroke_.voxels;
  std::sort(all.begin(), all.end());
  std::size_t kept = 0;
  for (std::size_t n = 0; n < all.size();) {
    std::size_t next = n;
    while (next < all.size() && all[next] == all[n]) ++next;
    if ((next - n) % 2) all[kept++] = all[n];
    n = next;
  }
  all.resize(kept);
  remember(stroke_name_, std::move(stroke_));
  stroke_ = {};
}

void MaskEditor::resetToAutomatic() {
  endStroke();
  apply("automatic mask", difference(mask_, automatic_));
}

std::optional<std::string> MaskEditor::undo() {
  endStroke();
  if (done_ == 0) return std::nullopt;
  flipNow(unpack(steps_[--done_].change));
  return steps_[done_].name;
}

std::optional<std::string> MaskEditor::redo() {
  endStroke();
  if (done_ == steps_.size()) return std::nullopt;
  flipNow(unpack(steps_[done_++].change));
  return steps_[done_ - 1].name;
}

std::uint64_t MaskEditor::state() const {
  if (!stroke_.empty()) return ~revision_;
  return done_ == 0 ? 0 : steps_[done_ - 1].state;
}

std::vector<std::string> MaskEditor::steps() const {
  std::vector<std::string> names;
  for (const Step& step : steps_) names.push_back(step.name);
  return names;
}

std::size_t MaskEditor::historyBytes() const {
  std::size_t bytes = 0;
  for (const Step& step : steps_) bytes += step.change.bytes.size();
  return bytes;
}

}  // namespace facenav::editing
