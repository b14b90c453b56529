#pragma once
// When a brain mask can be believed, and what the radiographer should look at.

#include <string>
#include <vector>

#include "bet_surface.h"
#include "brain_tissue.h"

namespace facenav::segmentation {

/// Throws Error "no brain can be modelled: ..." for a CT, and for a volume too small or flat to hold a head.
void requireBrainScan(const volume::Volume& volume);
/// Throws Error "no brain can be modelled: ..." where the tissues have no contrast.
void requireTissueContrast(const TissueModel& tissue);
/// Throws Error "no brain can be modelled: ..." where the middle of the head has one value throughout: a CT
/// that came without its modality, in which soft tissues differ by a few parts in a hundred of their distance
/// from air.
void requireTissueSpread(const volume::Volume& coarse, const BetSphere& sphere);
/// Throws Error "no brain can be modelled: ..." for volumes that no brain has; else warnings in plain words.
/// `brain` lies on the scan's own grid; `by_head`: the ball that the head's top and girth let expect, which
/// grants more to a head that is itself larger than any other (MNI's template is).
std::vector<std::string> checkBrain(const volume::Mask& brain, const BetSphere& by_head);

}  // namespace facenav::segmentation
