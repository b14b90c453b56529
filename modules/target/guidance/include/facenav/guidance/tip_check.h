#pragma once
// A check of the alignment that a person can judge: the coil's tip is held to nose or ear, or a spot is
// picked in a camera picture (a finger's tip at the nose, a mole), and the program says where it is on the
// MRI's skin. Nothing touches a marker on the head. In: tip or spot (Mri, mm). Out: its distance from the
// skin and the nearest named place. A person compares that with where it really is.

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
  double off_place_mm = 0;  // from the nearest named place
  What what = What::coil_tip;
  double sigma_mm = 0;  // of a picked spot's depth

  /// Near enough to the skin to be judged (within kNear_mm).
  bool isNear() const;
  static constexpr double kNear_mm = 40;
};
/// "0.8 mm outside the skin", "1.2 mm inside the skin".
std::string skinInWords(const TipReading& reading);
/// "3.2 mm from nose tip"; empty where no place is known.
std::string placeInWords(const TipReading& reading);
/// Both: "0.8 mm outside the skin, 3.2 mm from nose tip".
std::string inWords(const TipReading& reading);

class TipCheck {
 public:
  /// Throws Error for a skin without triangles. `places` may be empty.
  TipCheck(const surface::TriangleMesh& skin, std::vector<surface::NamedPlace> places);
  TipReading read(const Point<Mri>& tip) const;
  const std::vector<surface::NamedPlace>& places() const { return places_; }

 private:
  surface::ClosestPoint skin_;
  std::vector<surface::NamedPlace> places_;
};

}  // namespace facenav::guidance
