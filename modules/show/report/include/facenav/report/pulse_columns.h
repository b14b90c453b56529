#pragma once
// The numbers by which pulses can be coloured, sorted and plotted: name, unit, decimals and value of each.
// The names are the columns of pulses.csv.

#include <array>
#include <optional>
#include <string>

#include "facenav/casefile/pulse.h"

namespace facenav::report {

enum class PulseColumn {
  distance,
  lateral,
  depth,
  tilt,
  twist,
  gap,
  error_bound,
  intensity,
  field,
  mep,
  latency,
  time,
  field_per_rate,
  peak_field,
  peak_field_per_rate,
};

struct PulseColumnWords {
  PulseColumn column;
  const char* key;   // in pulses.csv
  const char* name;  // English
  const char* unit;
  int decimals;
};

/// Words of all columns, in the order of the enumeration.
const std::array<PulseColumnWords, 15>& pulseColumns();
const PulseColumnWords& wordsOf(PulseColumn column);
/// Value of a column; nothing if unknown. Twist and depth keep their sign.
std::optional<double> valueOf(const casefile::Pulse& pulse, PulseColumn column);
/// Value as text: "2.4"; empty if unknown.
std::string valueText(const casefile::Pulse& pulse, PulseColumn column);

}  // namespace facenav::report
