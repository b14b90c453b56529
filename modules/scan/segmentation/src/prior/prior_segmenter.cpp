#include "brain_checks.h"
#include "brain_start.h"
#include "facenav/core/error.h"
#include "facenav/core/settings_in_force.h"
#include "facenav/segmentation/segmenter.h"
#include "prior/prior_refinement.h"
#include "scan_grid.h"

namespace facenav::segmentation {
namespace {

class PriorSegmenter : public Segmenter {
 public:
  SegmentationResult segment(const volume::Volume& volume, TaskMonitor& monitor) const override {
    requireMr(volume);
    requireBrainScan(volume);
    monitor.report("looking for the brain", 0);
    const InstalledPrior& installed = installedPrior();
    if (!installed.network) throw Error(installed.fault);
    const volume::Volume working = workingVolume(volume, 1.0);
    const auto prior = findBrainPrior(*installed.network, working);
    if (!prior) throw Error("no brain can be modelled: nothing in this scan looks like one");
    monitor.report("fitting the brain's outline", 0.6);
    RefinedPrior refined = refinedPrior(working, *prior, settingsOf<PriorUse>());
    const Ball ball = ballLike(refined.mask);
    return {onScanGrid(refined.mask, volume.grid), checkBrain(refined.mask, {ball.centre_mm, ball.radius_mm}),
            std::move(refined.doubts)};
  }
};

}  // namespace

std::unique_ptr<Segmenter> makePriorSegmenter() { return std::make_unique<PriorSegmenter>(); }

}  // namespace facenav::segmentation
