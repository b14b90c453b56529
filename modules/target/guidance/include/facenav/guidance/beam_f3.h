#pragma once
// Beam F3: the place of F3 from three tape measures (Beam, Borckardt, Reeves and George 2009, Brain Stimul
// 2:50-54). In a flat map of the head with Cz at its centre, Fpz 40 % of nasion-inion in front of it and T7
// 40 % of tragus-tragus beside it, F3 is where the lines Fz-F7 and C3-Fp1 cross. The result is given as two
// lengths: x along the circumference from the midline, and y from the vertex towards that point.
// The article's printed equations contain slips; these are the ones of the calculator that clinics use
// (clinicalresearcher.org/F3), slips included, so that a target here is the target there. Checked against its
// output as others report it: x = 0.1154 circumferences and y = 0.2637 mean arcs where both arcs are equal.

#include "facenav/guidance/eeg_sites.h"

namespace facenav::guidance {

struct BeamF3Lengths {
  double x_mm = 0;  // along the circumference from Fpz to the left
  double y_mm = 0;  // from Cz towards that point
};
/// Throws Error for measures that no head has (100 to 1000 mm).
BeamF3Lengths beamF3Lengths(double nasion_inion_mm, double tragus_tragus_mm, double circumference_mm);

struct BeamF3 {
  BeamF3Lengths lengths;
  Point<Mri> point;             // on the skin
  Point<Mri> at_circumference;  // the end of x
};
/// Both lengths measured on the scalp as with a tape. `sites` must be those of `scalp`.
BeamF3 placeBeamF3(const surface::ScalpPaths& scalp, const EegSites& sites);

}  // namespace facenav::guidance
