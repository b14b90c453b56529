#include "facenav/peers/bet_segmenter.h"

#include "brain_checks.h"
#include "brain_start.h"
#include "facenav/volume/regrid.h"

namespace facenav::peers {
namespace {

using namespace segmentation;

class BetSegmenter : public Segmenter {
 public:
  SegmentationResult segment(const volume::Volume& volume, TaskMonitor& monitor) const override {
    requireMr(volume);
    requireBrainScan(volume);
    monitor.report("looking for the brain", 0);
    const volume::Volume working = workingVolume(volume, 1.0), coarse = halved(working);
    const BrainStart start = findBrainStart(coarse);
    requireTissueSpread(coarse, start.sphere);
    const BetSurface surface = evolveBet(coarse, start.sphere, start.intensities, BetOptions(), monitor);
    SegmentationResult result;
    result.mask = volume::resample(enclosed(surface, working.grid), volume.grid);
    result.warnings = checkBrain(result.mask, start.sphere);
    return result;
  }
};

}  // namespace

std::unique_ptr<segmentation::Segmenter> makeBetSegmenter() { return std::make_unique<BetSegmenter>(); }

}  // namespace facenav::peers
