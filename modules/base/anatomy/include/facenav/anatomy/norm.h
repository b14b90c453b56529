#pragma once
// Norm: the range of a measure of head, face or brain, with its unit, its population and its source. Every
// anatomical limit that FaceNav applies is a Norm, defined once, in *_norms.h.

#include <limits>

namespace facenav::anatomy {

inline constexpr double kNoLimit = std::numeric_limits<double>::infinity();

/// If no source was found for a range, `source` contains that.
struct Norm {
  const char* what;        // "brain with cerebellum"
  const char* unit;        // "mm", "ml", "1"
  double low, high;        // both included
  const char* population;  // "adults, both sexes"
  const char* source;      // article, survey, "judgement", or "fitted: on what"

  constexpr Norm(const char* what_is_measured, const char* its_unit, double lowest, double highest,
                 const char* measured_on, const char* taken_from)
      : what(what_is_measured),
        unit(its_unit),
        low(lowest),
        high(highest),
        population(measured_on),
        source(taken_from) {}

  constexpr bool contains(double value) const { return value >= low && value <= high; }
};

}  // namespace facenav::anatomy
