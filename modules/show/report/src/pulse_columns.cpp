#include "facenav/report/pulse_columns.h"

#include "facenav/core/error.h"
#include "facenav/core/number_text.h"

namespace facenav::report {

const std::array<PulseColumnWords, 15>& pulseColumns() {
  static const std::array<PulseColumnWords, 15> kColumns{{
      {PulseColumn::distance, "distance_mm", "error", "mm", 1},
      {PulseColumn::lateral, "lateral_mm", "sideways", "mm", 1},
      {PulseColumn::depth, "depth_mm", "depth", "mm", 1},
      {PulseColumn::tilt, "tilt_deg", "tilt", "deg", 1},
      {PulseColumn::twist, "twist_deg", "twist", "deg", 1},
      {PulseColumn::gap, "gap_mm", "gap", "mm", 1},
      {PulseColumn::error_bound, "error_bound_mm", "95 % within", "mm", 1},
      {PulseColumn::intensity, "intensity_pct", "output", "%", 0},
      {PulseColumn::field, "e_target_v_per_m", "field", "V/m", 0},
      {PulseColumn::mep, "mep_uv", "MEP", "uV", 0},
      {PulseColumn::latency, "latency_ms", "latency", "ms", 1},
      {PulseColumn::time, "t_s", "time", "s", 1},
      {PulseColumn::field_per_rate, "e_target_v_per_m_per_a_per_us", "field at 1 A/us", "V/m", 2},
      {PulseColumn::peak_field, "e_max_v_per_m", "largest field", "V/m", 0},
      {PulseColumn::peak_field_per_rate, "e_max_v_per_m_per_a_per_us", "largest at 1 A/us", "V/m", 2},
  }};
  return kColumns;
}

const PulseColumnWords& wordsOf(PulseColumn column) { return pulseColumns()[std::size_t(column)]; }

std::optional<double> valueOf(const casefile::Pulse& pulse, PulseColumn column) {
  const auto& offset = pulse.offset;
  const auto ofOffset = [&](double casefile::PulseOffset::*value) {
    return offset ? std::optional((*offset).*value) : std::nullopt;
  };
  switch (column) {
    case PulseColumn::distance:
      return ofOffset(&casefile::PulseOffset::distance_mm);
    case PulseColumn::lateral:
      return ofOffset(&casefile::PulseOffset::lateral_mm);
    case PulseColumn::depth:
      return ofOffset(&casefile::PulseOffset::depth_mm);
    case PulseColumn::tilt:
      return ofOffset(&casefile::PulseOffset::tilt_deg);
    case PulseColumn::twist:
      return ofOffset(&casefile::PulseOffset::twist_deg);
    case PulseColumn::gap:
      return pulse.gap_mm;
    case PulseColumn::error_bound:
      return pulse.error_bound_mm;
    case PulseColumn::intensity:
      return pulse.intensity_pct;
    case PulseColumn::field:
      return pulse.e_target_v_per_m;
    case PulseColumn::mep:
      return pulse.mep_uv;
    case PulseColumn::latency:
      return pulse.latency_ms;
    case PulseColumn::time:
      return pulse.t_s;
    case PulseColumn::field_per_rate:
      return pulse.field ? pulse.field->at_target : std::nullopt;
    case PulseColumn::peak_field:
      if (!pulse.field || !pulse.field->rate_A_per_us) return std::nullopt;
      return pulse.field->peak * *pulse.field->rate_A_per_us;
    case PulseColumn::peak_field_per_rate:
      return pulse.field ? std::optional(pulse.field->peak) : std::nullopt;
  }
  FACENAV_EXPECT(false, "unknown column");
}

std::string valueText(const casefile::Pulse& pulse, PulseColumn column) {
  const auto value = valueOf(pulse, column);
  return value ? fixed(*value, wordsOf(column).decimals) : std::string();
}

}  // namespace facenav::report
