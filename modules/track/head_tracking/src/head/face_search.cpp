#include "face_search.h"

#include <algorithm>

#include "facenav/head_tracking/search_budget.h"

namespace facenav::head_tracking {
namespace {

constexpr double kLeastAlike = 0.15;      // of a coarse fit; lower: no face
constexpr double kSwappedLikeness = 0.4;  // likeness with the images exchanged
// Other work of a frame, in patch comparisons that take the same time.
constexpr int kPyramidComparisons = 450, kEvenedComparisons = 250;
constexpr int kIdentityComparisons = 500;
constexpr int kFewestSteps = 4, kMostSteps = 8;

}  // namespace

bool HeadWork::leavesTimeToSearch() const {
  return comparisons <= std::max(0, settingsOf<SearchBudget>().before_search - left_out);
}
bool HeadWork::leavesTimeToFit() const {
  return comparisons <= settingsOf<SearchBudget>().before_fit - left_out;
}

int HeadWork::stepsLeft(const PatchModel& model) const {
  const int a_step = std::max(1, 2 * int(model.level[0].patches.size()));
  const int of_head = left() - settingsOf<FrameBudget>().coil_comparisons;
  return std::clamp((of_head - left_out - kIdentityComparisons) / a_step, kFewestSteps, kMostSteps);
}

FaceSearch::FaceSearch(const cameras::StereoRig& rig, const PatchModel& model,
                       const std::array<ImagePyramid, 2>& key, FaceTemplate face)
    : rig_(rig), model_(&model), coarse_(rig, key, std::move(face)), reference_(coarse_) {
  rough_level_ = model.level[2].patches.size() < kFewestPatches ? 1 : 2;
}

void FaceSearch::add(const std::array<ImagePyramid, 2>& now, const Eigen::Isometry3d& motion) {
  coarse_.add(rig_, now, motion);
}

void FaceSearch::forgetLearnt() {
  coarse_ = reference_;
  end();
}

PoseFit FaceSearch::roughly(const KeyFrames& keys, const std::array<ImagePyramid, 2>& now,
                            const Eigen::Isometry3d& start, HeadWork& work, int first_level) const {
  PoseFit fit =
      fitPose(rig_, *model_, keys.likeliest(start).level, now, start, first_level, {}, rough_level_);
  work.comparisons += fit.comparisons;
  return fit;
}

void FaceSearch::searchFrom(const KeyFrames& keys, const std::array<ImagePyramid, 2>& now,
                            const EvenedPair& evened, const std::optional<Eigen::Isometry3d>& from,
                            Found& found, HeadWork& work) const {
  const CoarseSearch::Places places = coarse_.find(rig_, evened, from, turn_);
  work.comparisons += places.comparisons;
  for (const auto& start : places.starts) {
    found.is_anything_alike = true;
    if (found.best.likeness > kLikely || !work.leavesTimeToFit()) break;
    PoseFit rough = roughly(keys, now, start, work, rough_level_);
    if (rough.likeness > found.best.likeness) found.best = std::move(rough);
  }
}

FaceSearch::Found FaceSearch::seek(const KeyFrames& keys, const std::array<ImagePyramid, 2>& now,
                                   const std::optional<Eigen::Isometry3d>& last,
                                   const std::optional<Eigen::Isometry3d>& expected, bool is_first,
                                   HeadWork& work) {
  Found found;
  work.comparisons += kPyramidComparisons;
  const bool was_deferred = deferred_.has_value();
  if (was_deferred || last)
    found.best = roughly(keys, now, deferred_ ? *deferred_ : expected.value_or(*last), work);
  deferred_.reset();
  const bool is_there = found.best.likeness > kLikely && (is_first || was_deferred);
  if (!is_there) {
    const EvenedPair evened(now);
    work.comparisons += kEvenedComparisons;
    searchFrom(keys, now, evened, last, found, work);
    if (last && is_first && found.best.likeness < kLikely)
      searchFrom(keys, now, evened, std::nullopt, found, work);  // a fast motion, at a few frames per second
    ++turn_;
    found.is_swapped = last && found.best.likeness < kLikely &&
                       roughly(keys, {now[1], now[0]}, *last, work).likeness >
                           std::max(kSwappedLikeness, found.best.likeness);
  }
  found.is_to_be_tried = !found.is_swapped && found.best.likeness >= kLeastAlike;
  if (found.is_to_be_tried && !work.leavesTimeToFit()) {
    deferred_ = found.best.motion;
    found.is_to_be_tried = false, found.is_deferred = true;
  }
  return found;
}

}  // namespace facenav::head_tracking
