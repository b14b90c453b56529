#pragma once
// NamedPlace: a place of the head with its name, as pictures and checks show it.

#include <string>

#include "facenav/geometry/point.h"

namespace facenav::surface {

struct NamedPlace {
  std::string name;
  Point<Mri> point;
  double sd_mm = 0;  // standard error along the skin; 0: unknown
};

}  // namespace facenav::surface
