#include <algorithm>
#include <cmath>
#include <optional>

#include "brain_checks.h"
#include "brain_start.h"
#include "contrast_seen.h"
#include "ct_brain.h"
#include "facenav/core/error.h"
#include "facenav/core/settings_in_force.h"
#include "facenav/segmentation/segmenter.h"
#include "facenav/volume/mask_morphology.h"
#include "facenav/volume/regrid.h"
#include "grown_brain.h"
#include "prior/averaged_prior.h"
#include "prior/leaks_and_gaps.h"
#include "prior/prior_refinement.h"
#include "prior/scan_prior.h"
#include "prior/stated_doubt.h"
#include "scan_grid.h"

namespace facenav::segmentation {
namespace {

using volume::Mask;
using volume::Volume;

struct Found {
  Mask mask;  // on a part of the working grid
  std::vector<BoundaryDoubt> doubts;
  BetSphere sphere;
  std::vector<std::string> warnings;
  std::string contrast = {};
};

Found byGrowthAlone(const Volume& working, const Volume& scan, TaskMonitor& monitor) {
  GrowthStart start = startFromHead(working, monitor);
  const BetSphere sphere = start.sphere;
  auto grown = growBrain(std::move(start), scan.grid, monitor, [](const Mask&) { return true; });
  return {std::move(grown->mask), std::move(grown->doubts), sphere, {}};
}

/// Adds the core: what lies deep within the prior's outline is brain, whatever its intensity (lesions).
Mask withCore(const Mask& grown, const Mask& refined, double core_mm) {
  return volume::fillHoles(unionOf(grown, volume::resample(erode(refined, core_mm), grown.grid)));
}

ContrastSeen contrastOf(const Volume& working, const BrainPrior& prior) {
  return contrastSeen(volume::resample(working, prior.brain.grid), prior.brain, prior.fluid);
}

double agreement(const Mask& grown, const Mask& refined) {
  return volume::overlap(grown, volume::resample(refined, grown.grid)).dice;
}

/// True if both masks agree. Growth from the head's shape is independent of the prior, so one sign of
/// agreement is enough. Growth from the prior's own outline needs both.
bool isAlike(const Mask& grown, const Mask& refined, bool is_by_prior, const PriorUse& use) {
  const bool agrees = agreement(grown, refined) >= use.least_agreement;
  if (agrees != is_by_prior) return agrees;
  return leaksAndGaps(grown, refined, use.far_mm) <= use.most_far;
}

/// Grows from a start within the reach of the refined prior's outline; nullopt if the two disagree.
template <class MakeStart>
std::optional<Found> grownAlike(MakeStart&& makeStart, const Mask& refined, bool is_by_prior,
                                const Volume& scan, TaskMonitor& monitor) {
  const PriorUse& use = settingsOf<PriorUse>();
  try {
    GrowthStart start = makeStart();
    const BetSphere sphere = start.sphere;
    auto grown = growBrain(std::move(start), scan.grid, monitor,
                           [&](const Mask& mask) { return isAlike(mask, refined, is_by_prior, use); });
    if (!grown) return std::nullopt;
    raiseDoubts(grown->doubts, refined);
    return Found{withCore(grown->mask, refined, use.core_mm), std::move(grown->doubts), sphere, {}};
  } catch (const Cancelled&) {
    throw;
  } catch (const Error&) {  // grey and white matter do not differ, or no head is found by its shape
    return std::nullopt;
  }
}

BetSphere sphereOf(const Mask& mask) {
  const Ball ball = ballLike(mask);
  return {ball.centre_mm, ball.radius_mm};
}

Found byPrior(RefinedPrior refined, const ContrastSeen& seen) {
  const BetSphere sphere = sphereOf(refined.mask);
  Found found{std::move(refined.mask), std::move(refined.doubts), sphere, {}};
  stateDoubts(found.doubts, seen.kind());
  found.warnings.push_back(
      seen.isLikeT1()
          ? "grey and white matter alone do not give the brain's outline: check it"
          : "this scan does not look like a T1 but like " + seen.inWords() +
                ": the brain's outline is less sure; a T1-weighted MR of the whole head is better");
  return found;
}

/// Brain of a CT: the prior's outline within the skull.
Found inCt(const Volume& ct, TaskMonitor& monitor) {
  const InstalledPrior& installed = installedPrior();
  if (!installed.network) requireMr({ct.grid, {}, "CT", {}});
  const Volume working = workingVolume(softTissueWindow(ct), 1.0);
  const auto prior = findBrainPrior(*installed.network, working);
  if (!prior)
    throw Error(
        "no brain can be modelled: nothing in this CT looks like one (a phantom, another part of the "
        "body, or a face alone)",
        {}, "a T1-weighted MR of the whole head is needed");
  monitor.report("fitting the brain's outline", 0.6);
  const PriorUse& use = settingsOf<PriorUse>();
  RefinedPrior refined = refinedPrior(working, *prior, use);
  requireSkullAround(ct, refined.mask);
  const Ball ball = ballLike(refined.mask);
  Found found{withinSkull(ct, refined.mask), std::move(refined.doubts), {ball.centre_mm, ball.radius_mm}, {}};
  found.warnings.push_back(
      "this is a CT, in which grey and white matter look alike: the brain's outline is the learned prior's, "
      "within the skull, and sure to some millimetres only; a T1-weighted MR of the whole head is better");
  found.contrast = "CT";
  return found;
}

/// Returns the growth's outline, which is exact to the voxel, if it agrees with the prior's; else the
/// prior's.
Found withPrior(const PriorNetwork& network, const Volume& working, const Volume& scan,
                const BrainPrior& prior, TaskMonitor& monitor) {
  const PriorUse& use = settingsOf<PriorUse>();
  const ContrastSeen seen = contrastOf(working, prior);
  const auto named = [&](Found found) {
    found.contrast = seen.inWords();
    return found;
  };
  requireTissueSpread(halved(working), sphereOf(prior.mask()));
  if (seen.isLikeT1()) {
    const Mask refined = refinedMask(working, prior, use);
    const auto by_head = [&] { return startFromHead(working, monitor); };
    if (auto found = grownAlike(by_head, refined, false, scan, monitor)) return named(std::move(*found));
    const auto by_prior = [&] { return startFromOutline(working, refined, use.search_mm); };
    if (auto found = grownAlike(by_prior, refined, true, scan, monitor)) return named(std::move(*found));
  }
  monitor.report("fitting the brain's outline", 0.6);
  return named(byPrior(refinedByTissue(working, averagedPrior(network, working, prior), use), seen));
}

Found inMr(const Volume& volume, TaskMonitor& monitor) {
  const InstalledPrior& installed = installedPrior();
  if (!installed.network) {
    Found found = byGrowthAlone(workingVolume(volume, 1.0), volume, monitor);
    found.warnings.push_back("without the learned brain prior: " + installed.fault);
    return found;
  }
  const auto seen = scanPrior(*installed.network, volume);
  monitor.report("looking for the brain", 0.4);
  if (!seen->prior) {
    Found found = byGrowthAlone(seen->working, volume, monitor);
    found.warnings.push_back(
        "the learned brain prior sees no brain in this scan: check the outline everywhere");
    return found;
  }
  return withPrior(*installed.network, seen->working, volume, *seen->prior, monitor);
}

class BrainSegmenter : public Segmenter {
 public:
  SegmentationResult segment(const Volume& volume, TaskMonitor& monitor) const override {
    requireBrainScan(volume);
    monitor.report("looking for the brain", 0);
    Found found = isCt(volume) ? inCt(volume, monitor) : inMr(volume, monitor);
    SegmentationResult result;
    result.mask = onScanGrid(found.mask, volume.grid);
    result.doubts = std::move(found.doubts);
    result.contrast = std::move(found.contrast);
    result.warnings = checkBrain(result.mask, found.sphere);
    result.warnings.insert(result.warnings.end(), found.warnings.begin(), found.warnings.end());
    return result;
  }
};

}  // namespace

std::unique_ptr<Segmenter> makeBrainSegmenter() { return std::make_unique<BrainSegmenter>(); }

}  // namespace facenav::segmentation
