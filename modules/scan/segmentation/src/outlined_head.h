#pragma once
// The head on blocks of about 2 mm, up to the end of tissue. The limit between air and tissue lies between
// the two levels of each place, so that shading, a bright nose and haze do not move it. Cavities are closed;
// pads (head_pads.h) and thin attachments (head holders, ghosts, wrap-around) are removed.

#include <string>

#include "block_means.h"
#include "head_threshold.h"

namespace facenav::segmentation {

struct OutlinedHead {
  volume::Mask mask;
  std::vector<float> limits;  // limit of each block: brighter is tissue
  volume::Mask pads;          // blocks outside the head, however bright
  double beside_ml = 0;       // volume that touches the head and was left out
  double haze = 0;            // signal just outside the head, as a share of the tissue's
  bool knows_pads = true;     // false: an MR without the learned prior's view of air
};

/// Segments the head. Throws Error ("no head in this volume: ..") if nothing of a head's size is bright
/// enough.
OutlinedHead outlinedHead(const volume::Volume& scan, const BlockMeans& coarse,
                          const HeadThreshold& threshold);

/// One sentence for each thing that was left out or could not be distinguished.
std::vector<std::string> leftOutInWords(const OutlinedHead& head);

}  // namespace facenav::segmentation
