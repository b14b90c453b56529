#include "report_field.h"

#include <map>
#include <set>
#include <vector>

#include "facenav/core/number_text.h"
#include "facenav/core/robust_statistics.h"
#include "facenav/report/pulse_columns.h"
#include "facenav/report/session_review.h"
#include "report_html.h"

namespace facenav::report {
namespace {

std::string modelWords(int tier) {
  // The usual errors are those of steps/plan/head_field.h.
  if (tier == 0) return "tier 0: a sphere fitted to the skull under the coil, usual error 28 %";
  if (tier == 1) return "tier 1: scalp, skull and brain of the case, usual error 23 %";
  if (tier == 2) return "tier 2: scalp, skull, fluid and brain of the case, usual error 19 %";
  return formatted("tier %d", tier);
}

/// "median 61.2, 95th percentile 64.0 V/m (120 pulses)"; empty: no pulse has it.
std::string rowOf(const casefile::KeptSession& session, PulseColumn column, int decimals) {
  std::vector<double> values;
  for (const auto& reviewed : session.pulses.pulses)
    if (const auto value = valueOf(reviewed.pulse, column); value && !reviewed.is_excluded)
      values.push_back(*value);
  if (values.empty()) return {};
  const auto spread = spreadOf(values);
  return formatted("median %.*f, 95th percentile %.*f V/m (%zu pulses)", decimals, spread->median, decimals,
                   spread->p95, values.size());
}

/// Median of the places of the maximum, along each axis.
std::string placeOf(const casefile::KeptSession& session) {
  std::vector<double> along[3];
  for (const auto& reviewed : session.pulses.pulses)
    if (reviewed.pulse.field && !reviewed.is_excluded)
      for (int c = 0; c < 3; ++c) along[c].push_back(reviewed.pulse.field->peak_place.mm[c]);
  if (along[0].empty()) return "not known";
  return formatted("RAS %.1f %.1f %.1f mm", median(along[0]), median(along[1]), median(along[2]));
}

}  // namespace

std::string fieldPart(const casefile::KeptSession& session) {
  std::set<std::string> coils;
  std::set<int> tiers;
  for (const auto& reviewed : session.pulses.pulses)
    if (const auto& field = reviewed.pulse.field) coils.insert(field->coil), tiers.insert(field->tier);
  std::vector<TableRow> rows;
  const auto add = [&](const char* name, const std::string& words) {
    if (!words.empty()) rows.push_back({name, words});
  };
  add("At the target", rowOf(session, PulseColumn::field, 0));
  add("At the target, for a current that rises by 1 A/us", rowOf(session, PulseColumn::field_per_rate, 2));
  add("Largest on the cortex", rowOf(session, PulseColumn::peak_field, 0));
  add("Largest on the cortex, for 1 A/us", rowOf(session, PulseColumn::peak_field_per_rate, 2));
  if (tiers.empty()) {
    if (rows.empty()) return {};
    return headingHtml("Electric field") + factsHtml(rows);
  }
  add("Place of the largest, median", placeOf(session));
  std::string models, names;
  for (const int tier : tiers) models += (models.empty() ? "" : "; ") + modelWords(tier);
  for (const auto& coil : coils) names += (names.empty() ? "" : "; ") + coil;
  add("Model of the head", models);
  add("Field of the coil", names);
  return headingHtml("Electric field") + factsHtml(rows);
}

}  // namespace facenav::report
