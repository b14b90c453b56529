#pragma once
// A check of the alignment that a person can judge. The coil's tip is held to nose or ear, or a spot is
// picked in a camera picture (a fingertip at the nose, a mole); the program shows its position on the MRI's
// skin. A person compares that with the true position. In: tip or spot (Mri, mm). Out: its distance from the
// skin and the nearest named place.

#include <optional>
#include <string>
#include <vector>

#include "facenav/surface/closest_point.h"
#include "facenav/surface/named_place.h"

namespace facenav::guidance {

struct TipReading {
  enum class What { coil_tip, picked_spot };
  Point<Mri> tip;              // or the picked spot
  surface::SurfacePoint skin;  // nearest to the tip
  double off_skin_mm = 0;      // > 0: outside the head
  std::optional<surface::NamedPlace> nearest;
  double off_place_mm = 0;  // distance from the nearest named place
  What what = What::coil_tip;
  double sigma_mm = 0;  // standard error of a picked spot's depth; 0 for the tip

  /// True if the tip is near enough to the skin to be judged (within kNear_mm).
  bool isNear() const;
  static constexpr double kNear_mm = 40;
};
/// Returns "0.8 mm outside the skin" or "1.2 mm inside the skin".
std::string skinInWords(const TipReading& reading);
/// Returns "3.2 mm from nose tip"; empty if no place is known.
std::string placeInWords(const TipReading& reading);
/// Returns both: "0.8 mm outside the skin, 3.2 mm from nose tip".
std::string inWords(const TipReading& reading);

class TipCheck {
 public:
  /// Builds the check. Throws Error for a skin without triangles. `places` may be empty.
  TipCheck(const surface::TriangleMesh& skin, std::vector<surface::NamedPlace> places);
  TipReading read(const Point<Mri>& tip) const;
  const std::vector<surface::NamedPlace>& places() const { return places_; }

 private:
  surface::ClosestPoint skin_;
  std::vector<surface::NamedPlace> places_;
};

}  // namespace facenav::guidance
