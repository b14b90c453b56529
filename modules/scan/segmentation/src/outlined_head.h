#pragma once
// The head on blocks of about 2 mm: where tissue ends. The limit between air and tissue lies between the two
// levels of each place, so that shading, a bright nose and haze do not move it. Cavities are closed; pads
// (head_pads.h) and thin attachments (head holders, ghosts, wrap-around) are removed.

#include <string>

#include "block_means.h"
#include "head_threshold.h"

namespace facenav::segmentation {

struct OutlinedHead {
  volume::Mask mask;
  std::vector<float> limits;  // of each block: what is brighter is tissue
  volume::Mask pads;          // blocks that hold no head, however bright
  double beside_ml = 0;       // of what touches the head and was left out
  double haze = 0;            // signal just outside the head, as a share of the tissue's
  bool knows_pads = true;     // false: an MR without the learned prior's view of air
};

/// Throws Error ("no head in this volume: ..") where nothing of a head's size stands out.
OutlinedHead outlinedHead(const volume::Volume& scan, const BlockMeans& coarse,
                          const HeadThreshold& threshold);

/// What was left out or could not be told apart, one sentence each.
std::vector<std::string> leftOutInWords(const OutlinedHead& head);

}  // namespace facenav::segmentation
