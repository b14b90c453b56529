#pragma once
// Beam F3: locates F3 from three tape measures (Beam, Borckardt, Reeves and George 2009, Brain Stimul
// 2:50-54). In a flat map of the head with Cz at its centre, Fpz 40 % of nasion-inion in front of it and T7
// 40 % of tragus-tragus beside it, F3 is where the lines Fz-F7 and C3-Fp1 cross. The result is given as two
// lengths: x along the circumference from the midline, and y from the vertex towards that point.
// The article's printed equations contain errors. These equations reproduce the calculator that clinics use
// (clinicalresearcher.org/F3), errors included, so that both give the same target. Evidence:
// resources/doc/evidence.md. F4 is the same point of the right side.

#include "facenav/guidance/eeg_sites.h"
#include "facenav/guidance/hand_knob.h"

namespace facenav::guidance {

struct BeamF3Lengths {
  double x_mm = 0;  // along the circumference from Fpz to the side
  double y_mm = 0;  // from Cz towards that point
};
/// Computes both lengths. Throws Error for measures that no head has (outside 100 to 1000 mm).
BeamF3Lengths beamF3Lengths(double nasion_inion_mm, double tragus_tragus_mm, double circumference_mm);

struct BeamF3 {
  BeamF3Lengths lengths;
  Point<Mri> point;             // on the skin
  Point<Mri> at_circumference;  // the end of x
};
/// Locates F3, or F4 on the right side, by measuring both lengths on the scalp as with a tape. `sites` must
/// belong to `scalp`.
BeamF3 placeBeamF3(const surface::ScalpPaths& scalp, const EegSites& sites, Side side = Side::left);

}  // namespace facenav::guidance
