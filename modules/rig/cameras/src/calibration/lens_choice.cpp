#include "lens_choice.h"

#include <algorithm>

namespace facenav::cameras {
namespace {

constexpr std::size_t kFolds = 5;

// The usual model comes first. Another model is chosen when its error on views left out is below `needed`
// times that of the best so far: a fuller model must reduce the error, a simpler one must not increase it
// much.
struct Candidate {
  LensModel model;
  double needed;
};
const Candidate kCandidates[] = {{{"k1 k2 p1 p2", {4, true}}, 0},
                                 {{"k1 k2", {4, false}}, 1.0},
                                 {{"k1 k2 p1 p2 k3", {5, true}}, 0.97},
                                 {{"rational (k1..k6 p1 p2)", {8, true}}, 0.97}};

double heldOutRms(const BoardViews& task, const ViewIndices& used, const LensModel& model) {
  const std::size_t folds = std::min(kFolds, used.size());
  std::vector<ViewFit> held_out;
  for (std::size_t fold = 0; fold < folds; ++fold) {
    ViewIndices kept, left_out;
    for (std::size_t i = 0; i < used.size(); ++i) (i % folds == fold ? left_out : kept).push_back(used[i]);
    for (const auto& fit : fitViews(task, solve(task, kept, model).rig, left_out)) held_out.push_back(fit);
  }
  return rmsOf(held_out);
}

}  // namespace

const LensModel& usualLens() { return kCandidates[0].model; }

RigFit solve(const BoardViews& task, const ViewIndices& used, const LensModel& model) {
  std::vector<const BoardView*> views;
  for (const std::size_t i : used) views.push_back(&task.views[i]);
  return adjustRig(views, task.size, task.board, model.terms);
}

LensChoice chooseLens(const BoardViews& task, const ViewIndices& used, TaskMonitor& monitor) {
  LensChoice choice{usualLens(), 0, {}};
  for (const Candidate& candidate : kCandidates) {
    monitor.report("cross-validate", double(&candidate - kCandidates) / double(std::size(kCandidates)));
    const double rms_px = rmsOf(fitViews(task, solve(task, used, candidate.model).rig, used));
    const double held_out_px = heldOutRms(task, used, candidate.model);
    choice.tried.push_back({candidate.model.name, rms_px, held_out_px});
    const bool is_first = choice.tried.size() == 1;
    if (!is_first && !(held_out_px < candidate.needed * choice.held_out_rms_px)) continue;
    choice.taken = candidate.model;
    choice.held_out_rms_px = held_out_px;
  }
  return choice;
}

}  // namespace facenav::cameras
