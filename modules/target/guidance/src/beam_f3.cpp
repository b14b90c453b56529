#include "facenav/guidance/beam_f3.h"

#include <cmath>

#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "facenav/geometry/rotation.h"

namespace facenav::guidance {
namespace {

// Angles of F7 and Fp1 round the flat map, as in the calculator. The article has 288 for Fp1.
constexpr double kF7_rad = 324 * kRadPerDeg, kFp1_rad = 298 * kRadPerDeg;
constexpr double kPartOfArc = 0.4;    // from Cz to the circumference
constexpr double kFlatToTape = 0.91;  // as in the calculator; the article has 0.9

void requireHead(const char* what, double value_mm) {
  if (value_mm >= 100 && value_mm <= 1000) return;
  throw Error(formatted("the %s measures %.0f mm; no head does", what, value_mm), {}, "check the landmarks");
}

}  // namespace

BeamF3Lengths beamF3Lengths(double nasion_inion_mm, double tragus_tragus_mm, double circumference_mm) {
  requireHead("way from nasion to inion", nasion_inion_mm);
  requireHead("way from tragus to tragus", tragus_tragus_mm);
  requireHead("circumference", circumference_mm);
  const double ahead_mm = kPartOfArc * nasion_inion_mm, beside_mm = kPartOfArc * tragus_tragus_mm;
  // y = a x - ahead / 2 is the line through Fz, y = b (x - beside / 2) the line through C3.
  const double a = (beside_mm * std::sin(kF7_rad) + ahead_mm / 2) / beside_mm;
  const double b = ahead_mm * std::sin(kFp1_rad) / (ahead_mm * std::cos(kFp1_rad) - beside_mm / 2);
  const double x = (ahead_mm - beside_mm * b) / (2 * (a - b));
  const double y = a * x - ahead_mm / 2;
  const double from_midline_rad = M_PI / 2 + std::atan(y / x);
  return {circumference_mm * from_midline_rad / (2 * M_PI), kFlatToTape * std::hypot(x, y)};
}

BeamF3 placeBeamF3(const surface::ScalpPaths& scalp, const EegSites& sites, Side side) {
  BeamF3 beam;
  beam.lengths = beamF3Lengths(sites.nasion_inion_mm, sites.tragus_tragus_mm, sites.circumference_mm);
  const auto at = [&](const char* name) { return sites.find(name).point.mm; };
  const auto round = scalp.tape(at("Fpz"), at(side == Side::left ? "T7" : "T8"), at("Oz"));
  beam.at_circumference = scalp.onSkin(round.at(beam.lengths.x_mm)).point;
  const auto way = scalp.shortest(at("Cz"), beam.at_circumference.mm);
  beam.point = scalp.onSkin(way.at(beam.lengths.y_mm)).point;
  return beam;
}

}  // namespace facenav::guidance
