// The map of the MEPs by field in words, and on a surface.

#include <cmath>
#include <limits>

#include "facenav/core/number_text.h"
#include "facenav/treat/mep_by_field.h"
#include "facenav/treat/pulse_fields.h"

namespace facenav::steps {
namespace {

bool isLog(const MepByField& map) { return map.regression.response == stimulation::FieldResponse::log; }

std::string spotWords(const MepByField& map) {
  const auto& found = map.regression;
  const auto& p = map.spot.mm;
  return formatted(
      "spot that explains the muscle: %.1f %.1f %.1f mm, R2 %.2f (%s MEP; linear %.2f, log %.2f)", p.x(),
      p.y(), p.z(), found.r2, isLog(map) ? "logarithm of the" : "straight line of the",
      double(found.r2_linear.maxCoeff()), double(found.r2_log.maxCoeff()));
}

}  // namespace

std::string curveWords(const MepByField& map) {
  const auto& curve = map.curve;
  using stimulation::CurveVerdict;
  if (curve.verdict == CurveVerdict::no_bend)
    return "no sigmoid: the pulses lie on one side of its bend alone; give weaker and stronger ones";
  if (curve.verdict == CurveVerdict::line)
    return formatted("no sigmoid: a straight line describes the %s as well (AICc gain %.1f, %.0f needed)",
                     isLog(map) ? "MEPs' logarithms" : "MEPs", curve.aicc_gain, stimulation::kLeastGain);
  return formatted(
      "a sigmoid describes the %s better than a line: R2 %.2f instead of %.2f, AICc gain %.1f; its middle "
      "lies at %.2f V/m at 1 A/us%s",
      isLog(map) ? "MEPs' logarithms" : "MEPs", curve.r2_sigmoid, curve.r2_line, curve.aicc_gain,
      curve.sigmoid.midpoint, map.by_rate ? ", times the output" : "");
}

std::vector<std::string> inWords(const MepByField& map, const std::string& coil) {
  const auto& found = map.regression;
  std::vector<std::string> lines;
  lines.push_back(formatted("%d pulses with MEP and pose, regressed on the local field (coil %s, tier %d%s)",
                            map.pulses, fieldCoilName(coil).c_str(), int(map.tier),
                            map.by_rate ? ", at each pulse's output" : "; no output is known"));
  if (map.left_out > 0)
    lines.push_back(formatted("%d more have an MEP, but no pose or no output: left out", map.left_out));
  if (!found.is_explained) {
    lines.push_back("nothing is explained: no place of the cortex explains the MEPs better than chance");
    lines.push_back(
        formatted("best R2 %.2f; shuffled MEPs reach it in %.0f %%", found.r2, 100 * found.chance));
    return lines;
  }
  lines.push_back(spotWords(map));
  lines.push_back(formatted("region: 95 %% of resampled pulses have their spot within %.1f mm, at %d places",
                            map.region_mm, map.region_places));
  lines.push_back(formatted("shuffled MEPs reach this R2 in %.1f %%", 100 * found.chance));
  lines.push_back(curveWords(map));
  return lines;
}

std::vector<float> r2On(const surface::TriangleMesh& surface, const PoseFields& fields,
                        const MepByField& map) {
  const auto& r2 = map.regression.response == stimulation::FieldResponse::log ? map.regression.r2_log
                                                                              : map.regression.r2_linear;
  std::vector<float> at_places(std::size_t(fields.places_mm().cols()),
                               std::numeric_limits<float>::quiet_NaN());
  for (std::size_t i = 0; i < map.places.size(); ++i)
    at_places[std::size_t(map.places[i])] = r2[Eigen::Index(i)];
  std::vector<float> values;
  values.reserve(surface.vertices_mm.size());
  for (const Eigen::Index place : fields.nearestPlaces(surface.vertices_mm))
    values.push_back(at_places[std::size_t(place)]);
  return values;
}

}  // namespace facenav::steps
