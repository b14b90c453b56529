#pragma once
// Norm: the range that a measure of head, face or brain has in people, with its unit, whom it was measured on
// and where it is published. Every number of human anatomy by which FaceNav judges is one, stated once, in
// *_norms.h.

#include <limits>

namespace facenav::anatomy {

inline constexpr double kNoLimit = std::numeric_limits<double>::infinity();

/// A range that no source has been found for says so in `source`.
struct Norm {
  const char* what;        // "brain with cerebellum"
  const char* unit;        // "mm", "ml", "1"
  double low, high;        // both belong to the range
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
