#pragma once
// Segmenter: Volume -> Mask. "head": everything inside the skin; "brain": tissue of the brain. Only Mask
// connects it to the surface module.

#include <memory>
#include <string>
#include <vector>

#include "facenav/core/task_monitor.h"
#include "facenav/volume/volume.h"

namespace facenav::segmentation {

/// Uncertainty of a place on the mask's surface: the distance to the surface that the same method finds with
/// other thresholds, within the range that the scan allows.
struct BoundaryDoubt {
  Point<Mri> place;
  float doubt_mm;
};

struct SegmentationResult {
  volume::Mask mask;                  // on the grid of the input volume
  std::vector<std::string> warnings;  // plain words for the radiographer
  std::vector<BoundaryDoubt> doubts =
      {};                     // evenly spread over the mask's surface; empty: the method gives none
  std::string contrast = {};  // apparent contrast of the scan as text: "T1", "CT", ..; empty: not determined
};

class Segmenter {
 public:
  virtual ~Segmenter() = default;
  /// Throws Error when there is nothing to segment ("no head in this volume", "no brain can be modelled:
  /// ...").
  virtual SegmentationResult segment(const volume::Volume& volume, TaskMonitor& monitor) const = 0;
};

/// "head": the filled head without inner cavities. The threshold is robust to noise, bias and ghosting. T1 MR
/// and CT. In an MR without the learned prior's view of air a warning says that pads were not separated from
/// skin.
std::unique_ptr<Segmenter> makeHeadSegmenter();
/// "brain", the default: in a T1 grey and white matter with closed sulci, grown from BET's surface or from
/// the learned prior, where both agree; otherwise, and in any other contrast of MR, the prior's outline
/// fitted to the scan (with a warning); in a CT of the head the prior's outline within the skull. Without the
/// prior's weights: growth from BET's surface alone, and no brain in a CT. An MR in which the prior sees no
/// brain: the same growth. Both give a warning.
std::unique_ptr<Segmenter> makeBrainSegmenter();

/// "prior": the learned brain prior's outline (Data/brain_prior), fitted to the scan; any contrast of MR.
/// Throws Error also if the weights are missing or damaged.
std::unique_ptr<Segmenter> makePriorSegmenter();

}  // namespace facenav::segmentation
