#include "facenav/guidance/tip_check.h"

#include <cmath>

#include "facenav/core/number_text.h"

namespace facenav::guidance {

bool TipReading::isNear() const { return std::abs(off_skin_mm) <= kNear_mm; }

std::string skinInWords(const TipReading& reading) {
  return formatted("%.1f mm %s the skin", std::abs(reading.off_skin_mm),
                   reading.off_skin_mm < 0 ? "inside" : "outside");
}

std::string placeInWords(const TipReading& reading) {
  if (!reading.nearest) return {};
  return formatted("%.1f mm from ", reading.off_place_mm) + reading.nearest->name;
}

std::string inWords(const TipReading& reading) {
  const std::string place = placeInWords(reading);
  return skinInWords(reading) + (place.empty() ? "" : ", " + place);
}

TipCheck::TipCheck(const surface::TriangleMesh& skin, std::vector<surface::NamedPlace> places)
    : skin_(skin), places_(std::move(places)) {}

TipReading TipCheck::read(const Point<Mri>& tip) const {
  TipReading reading{tip, skin_.nearest(tip), 0, {}, 0};
  reading.off_skin_mm = reading.skin.is_outside ? reading.skin.distance_mm : -reading.skin.distance_mm;
  for (const auto& place : places_) {
    const double off_mm = (place.point.mm - tip.mm).norm();
    if (reading.nearest && off_mm >= reading.off_place_mm) continue;
    reading.nearest = place;
    reading.off_place_mm = off_mm;
  }
  return reading;
}

}  // namespace facenav::guidance
