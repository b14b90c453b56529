#pragma once
// TREAT: the motor hotspot. Makes a grid of sites round a target, and maps the muscle's responses on the
// cortex with centre of gravity, peak and area (guidance/mep_map.h).

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "facenav/casefile/session_pulses.h"
#include "facenav/guidance/mep_map.h"

namespace facenav::steps {

struct HuntingGrid {
  int rows = 5, columns = 5;  // along the handle, and across it
  double spacing_mm = 10;     // at the depth of the seed's cortex point, in the coil's plane
};
/// Makes the sites with their names ("M1 hand L 2/3": row, column), the seed in the middle, the nearest to it
/// first, so that a search that is stopped early has covered the middle. Sites without scalp below them are
/// left out. Throws Error for a grid of more than 15 x 15, or a spacing outside 1..40 mm.
std::vector<guidance::Target> huntingSites(const guidance::Target& seed, const surface::ScalpSurface& scalp,
                                           const HuntingGrid& grid);

struct Hotspot {
  /// Map of the MEPs in uV; if only twitches were answered, of the share of pulses that made the muscle
  /// twitch.
  guidance::MepMap map;
  bool is_share = false;
  int pulses = 0;         // with an answer and a position on the cortex
  int without_place = 0;  // with an answer, but the pose was lost or the axis misses the cortex
  double sigma_mm = 0;    // of the map's Gaussian
  int peak_pulse = 0;     // number of the pulse with the largest answer
};
/// Finds the hotspot from the pulses that are not excluded. `surface`: the cortex, else the brain model.
/// Nothing if no pulse gave a response.
std::optional<Hotspot> hotspotOf(const surface::TriangleMesh& surface, const casefile::SessionPulses& session,
                                 const std::map<int, bool>& twitches);

}  // namespace facenav::steps
