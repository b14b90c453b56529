#pragma once
// Refuses impossible brain masks, and collects what the radiographer must check.

#include <string>
#include <vector>

#include "bet_surface.h"
#include "brain_tissue.h"

namespace facenav::segmentation {

/// Throws Error "no brain can be modelled: ..." for a CT, and for a volume too small or flat to contain a
/// head.
void requireMr(const volume::Volume& volume);
/// Throws Error "no brain can be modelled: ..." for a scan too small to contain a brain.
void requireBrainScan(const volume::Volume& volume);
/// Throws Error "no brain can be modelled: ..." where the tissues have no contrast.
void requireTissueContrast(const TissueModel& tissue);
/// Throws Error "no brain can be modelled: ..." where the middle of the head has nearly one value: a CT
/// without its modality, in which soft tissues differ by a few percent of their distance from air.
void requireTissueSpread(const volume::Volume& coarse, const BetSphere& sphere);
/// Throws Error "no brain can be modelled: ..." for a volume that no brain has; otherwise returns warnings in
/// plain words. `brain` is on the scan's own grid. `by_head`: the brain's ball estimated from the head's top
/// and girth; it raises the limit for a head that is larger than any other (MNI's template is).
std::vector<std::string> checkBrain(const volume::Mask& brain, const BetSphere& by_head);

}  // namespace facenav::segmentation
