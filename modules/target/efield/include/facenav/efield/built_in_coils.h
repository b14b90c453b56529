#pragma once
// Coils that are built in: a figure-8 of 70 mm and a round coil of 90 mm, from their published windings. Few
// dipoles stand for each winding: rings whose radii and moments give the winding's own radial moments, so
// that the field below agrees (after Stenroos and Koponen, NeuroImage 203 (2019) 116159). Frame Coil.

#include <vector>

#include "facenav/efield/coil_dipoles.h"

namespace facenav::efield {

/// Concentric turns of flat wire about an axis along z.
struct Spiral {
  Eigen::Vector3d centre_mm = Eigen::Vector3d::Zero();  ///< middle of the conductor, frame Coil
  double first_radius_mm = 0, pitch_mm = 0;  ///< middle of the innermost turn, and from turn to turn
  int turns = 1;
  double width_mm = 1, height_mm = 1;  ///< of the wire: along the radius, and along z
  int sense = 1;                       ///< 1: its magnetic moment points into the head (+z); -1: out of it
  double radius_mm(int turn) const { return first_radius_mm + turn * pitch_mm; }
};

/// Windings of the figure-8 coil of 70 mm: 9 turns of 1 x 7 mm wire a wing, radii 26 to 44 mm, centres 88 mm
/// apart, casing 3 mm (Thielscher and Kammer, Clin Neurophysiol 115 (2004) 1697). A rising current drives the
/// field under the centre along -y.
std::vector<Spiral> figureEightWinding();
/// Winding of the round coil of 90 mm mean diameter: 14 turns between 66 and 123 mm (the maker's data of the
/// Magstim 90 mm coil). Wire height and casing are not given there; those of the figure-8 are used. A rising
/// current runs counter-clockwise seen from above the head.
std::vector<Spiral> roundWinding();

/// Dipoles of the same radial moments as the spirals: one at each centre and `rings` rings of
/// `dipoles_a_ring`, in one layer (the middle plane of the wire) or two. Throws Error unless there are 1 to 8
/// rings.
CoilDipoles matchedDipoles(const std::vector<Spiral>& spirals, int rings, int dipoles_a_ring, int layers = 1);

/// The figure-8 of 70 mm as 42 dipoles: relative error of its field in a sphere 0.6 % from 12 mm depth on.
CoilDipoles figureEight70();
/// The round coil as 98 dipoles: relative error 0.1 % from 12 mm depth on.
CoilDipoles roundCoil();

}  // namespace facenav::efield
