#include "exposure_words.h"

#include <algorithm>
#include <cmath>

#include "facenav/core/error.h"
#include "facenav/core/number_text.h"

namespace facenav::cameras {
namespace {

// With fewer views, a small delay common to all cannot be separated from the cameras' real pose.
constexpr std::size_t kFewestStill = 8;
// If half the views moved, those that passed the test probably moved too, by a little less.
constexpr double kLeastSimultaneous = 0.5;
constexpr double kNotedShare = 0.1;  // share of views that moved: more than a slip of the hand
// Limits for the error of both cameras together, relative to each alone, and in px. Lens models make it some
// 0.05 px larger.
constexpr double kNotedByAlone = 1.6, kNotedDisagreement_px = 0.15;
const char* const kRemedy = "trigger both cameras together, or hold the board still for each pair";

double farthestMoved_mm(const BoardViews& task, const StereoRig& rig, const ViewIndices& moved) {
  double farthest_mm = 0;
  for (const std::size_t i : moved)
    farthest_mm = std::max(farthest_mm, movedBetween_mm(rig, task.views[i], task.board));
  return farthest_mm;
}

std::string notTogether(const BoardViews& task, const StereoRig& rig, const ViewIndices& moved) {
  return formatted(
      "the cameras were not triggered together: the board moved between the two exposures in %.0f of %.0f "
      "views, by up to %.1f mm",
      double(moved.size()), double(task.views.size()), farthestMoved_mm(task, rig, moved));
}

}  // namespace

void requireSimultaneous(const BoardViews& task, const TrustedViews& trusted) {
  const std::size_t good = trusted.used.size() + trusted.moved.size();
  const std::size_t needed =
      std::max(kFewestStill, std::size_t(std::ceil(kLeastSimultaneous * double(good))));
  if (trusted.moved.empty() || trusted.used.size() >= needed) return;
  ViewIndices enough = trusted.used;  // for a rig that measures how far the board moved
  for (const std::size_t i : trusted.moved)
    if (enough.size() < kFewestStill) enough.push_back(i);
  throw Error(notTogether(task, solve(task, enough, usualLens()).rig, trusted.moved) + ", " +
                  std::to_string(trusted.used.size()) + " views are left and " + std::to_string(needed) +
                  " are needed",
              {}, std::string(kRemedy) + ", and check that both lists name the pairs in one order");
}

std::vector<std::string> simultaneityWarnings(const BoardViews& task, const TrustedViews& trusted,
                                              const Calibration& result) {
  if (trusted.moved.size() >= 2 && double(trusted.moved.size()) > kNotedShare * double(task.views.size()))
    return {notTogether(task, result.rig, trusted.moved) + ". Better " + kRemedy};
  if (result.rms_px > std::max(kNotedByAlone * trusted.alone_px, kNotedDisagreement_px))
    return {
        formatted("both cameras together fit the views to %.2f px, each alone to %.2f px: the board may have "
                  "moved between the two exposures, or a camera between the views. Better ",
                  result.rms_px, trusted.alone_px) +
        kRemedy};
  return {};
}

std::string reasonFor(const BoardViews& task, const TrustedViews& trusted, const StereoRig& rig,
                      std::size_t i) {
  const auto isIn = [i](const ViewIndices& list) {
    return std::find(list.begin(), list.end(), i) != list.end();
  };
  const bool is_left = isIn(trusted.bad_left), is_right = isIn(trusted.bad_right);
  const std::string side = is_left && is_right ? "left and right" : is_left ? "left" : "right";
  if (is_left || is_right) return "corners of the " + side + " image are off: blur, or a wrong corner";
  return formatted(
      "disagrees with the other views: the exposures were not simultaneous, the board moved %.1f mm "
      "between them",
      movedBetween_mm(rig, task.views[i], task.board));
}

}  // namespace facenav::cameras
