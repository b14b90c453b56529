#include "commands/field_print.h"

#include <cmath>
#include <cstdio>

#include "commands/import_field.h"
#include "facenav/core/number_text.h"
#include "facenav/efield/current_arrows.h"
#include "facenav/geometry/json_transform.h"
#include "facenav/guidance/handle.h"
#include "json_output.h"

namespace facenav::app {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kOnCrown_deg =
    30;  // a normal nearer to the direction out of the head has little field along it
constexpr std::size_t kMostLabels = 4;
constexpr double kLeastLabel_ml = 0.05;  // printed as 0.1

/// "1.234 V/m at 1 A/us", and at the rate if it is known.
std::string strength(const FieldReport& report, double at_unit_rate) {
  const std::string unit = formatted("%.3f V/m at 1 A/us", at_unit_rate);
  if (!report.rate_A_per_us) return unit;
  return formatted("%.1f V/m (", at_unit_rate * *report.rate_A_per_us) + unit + ")";
}

/// Labels of a region, largest first.
std::vector<std::pair<std::string, double>> largestLabels(const steps::FieldRegion& region) {
  std::vector<std::pair<std::string, double>> labels(region.by_label.begin(), region.by_label.end());
  const auto is_tiny = [](const auto& label) { return label.second < kLeastLabel_ml; };
  labels.erase(std::remove_if(labels.begin(), labels.end(), is_tiny), labels.end());
  std::sort(labels.begin(), labels.end(), [](const auto& a, const auto& b) { return a.second > b.second; });
  if (labels.size() > kMostLabels) labels.resize(kMostLabels);
  return labels;
}

bool isImported(const FieldReport& report) { return report.head->tier() == steps::FieldTier::imported; }

void printCoil(const FieldReport& report) {
  const auto& coil = report.coil;
  if (isImported(report)) return (void)std::printf("coil         that of the imported field\n");
  std::printf("coil         %s, %td dipoles", coil.dipoles.name.c_str(), coil.dipoles.positions_mm.cols());
  if (coil.thinning_error > 0)
    std::printf(" for %d (error %.2f %%)", coil.dipoles_in_file, 100 * coil.thinning_error);
  std::printf("\n");
  for (const auto& note : coil.notes) std::printf("note: %s\n", note.c_str());
}

void printImported(const FieldReport& report) {
  if (!report.imported) return;
  if (isImported(report))
    std::printf("%s", inLines(*report.imported).c_str());
  else
    std::printf("note: a field was imported for this pose: --tier 3 shows it\n");
}

void printModel(const FieldReport& report) {
  printCoil(report);
  std::printf("pose         as planned for '%s', gap %.1f mm\n", report.target.name.c_str(),
              guidance::centreGap_mm(report.target));
  std::printf("model        tier %d: %s; usual error %.0f %%\n", int(report.head->tier()),
              report.head->inWords().c_str(), 100 * report.head->usualError());
  if (report.rate_A_per_us) std::printf("current      rises by %.1f A/us\n", *report.rate_A_per_us);
}

void printStrengths(const FieldReport& report) {
  const auto& field = report.on_cortex;
  std::printf("at target    %s\n", strength(report, field.at_target.norm()).c_str());
  std::printf("across       %s\n",
              std::isnan(field.along_normal)
                  ? "not known: the field has no directions"
                  : (strength(report, std::abs(field.along_normal)) + " along the cortex' normal").c_str());
  if (field.normal.off_radial_deg < kOnCrown_deg)
    std::printf(
        "note: the target lies on a crown: its normal points out of the head, where the field is small\n");
  if (!report.has_sulci)
    std::printf("note: the case has no cortex with sulci: the normal is that of the brain's hull\n");
  const auto& p = field.peak_place.mm;
  std::printf("maximum      %s, %.1f mm from the target, at RAS %.1f %.1f %.1f mm\n",
              strength(report, field.peak).c_str(), field.peak_distance_mm, p.x(), p.y(), p.z());
}

void printRegions(const FieldReport& report) {
  if (!report.regions) return;
  const char* surface = report.has_sulci ? "cortex" : "the brain's hull";
  for (const auto& region : *report.regions) {
    std::printf("above %.0f %%   %.0f mm2 of %s, %.1f ml of the brain", 100 * region.share, region.area_mm2,
                surface, region.volume_ml);
    const char* between = ": ";
    for (const auto& [name, ml] : largestLabels(region)) {
      std::printf("%s%s %.1f", between, name.c_str(), ml);
      between = ", ";
    }
    std::printf("\n");
  }
}

/// "-12 % at the target, maximum 1.03 of it and 9.0 mm from it, correlation 0.87".
std::string differenceWords(const steps::PoseComparison& compared) {
  return formatted("%+.0f %% at the target, maximum %.2f of it and %.1f mm from it, correlation %.2f",
                   100 * compared.change(), compared.peak_ratio, compared.peak_shift_mm,
                   compared.correlation);
}

void printComparisons(const FieldReport& report) {
  if (const auto& compared = report.best_comparison)
    std::printf("             against the planned pose: %s\n", differenceWords(*compared).c_str());
  if (const auto& compared = report.pose_comparison)
    std::printf("against      the pose of '%s' would give: %s; at its own target %s\n",
                report.against.c_str(), differenceWords(*compared).c_str(),
                strength(report, compared->other_at_its_own).c_str());
  if (const auto& imported = report.comparison) {
    std::printf(
        "compared     %d points: relative error %.1f %%, maximum %.2f of the imported one, %.1f mm from it\n",
        imported->points, 100 * imported->relative_error, imported->peak_ratio, imported->peak_shift_mm);
    if (imported->is_scaled)
      std::printf(
          "             scaled first: the imported field is that of %.2f A/us; --didt gives its rate\n",
          imported->scale);
  }
}

void printExtras(const FieldReport& report) {
  if (const auto& best = report.best) {
    // The coil's x points to the left of a person who looks along its axis into the head.
    std::printf(
        "best pose    turned by %.0f deg clockwise, moved by %.1f mm to the %s (seen from above) and %.1f mm "
        "%s: %s\n",
        best->turned_deg, std::abs(best->x_mm), best->x_mm >= 0 ? "left" : "right", std::abs(best->y_mm),
        best->y_mm < 0 ? "backwards" : "forwards", strength(report, best->best).c_str());
    std::printf(
        "             planned %.3f V/m at 1 A/us (%+.0f %%); %d poses in %.1f s; the plan stays as it is\n",
        best->planned, 100 * (best->best / best->planned - 1), best->poses, report.best_s);
  }
  printComparisons(report);
  if (const auto& change = report.without_fluid)
    std::printf(
        "by the fluid the field changes by %.0f %% against tier 1; maximum %.2f of that one, %.1f mm from "
        "it\n",
        100 * change->relative_error, change->peak_ratio, change->peak_shift_mm);
  if (const auto& dose = report.dose)
    std::printf("dose         %.0f %% of the output gives the target the field of '%s' at %.0f %%%s\n",
                dose->output_pct, dose->hotspot.c_str(), dose->threshold_pct,
                dose->output_pct > 100 ? ": more than the stimulator has" : "");
}

Json vectorJson(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

Json coilJson(const FieldReport& report) {
  const auto& coil = report.coil;
  Json json{{"name", coil.dipoles.name},
            {"dipoles", coil.dipoles.positions_mm.cols()},
            {"dipoles_in_file", coil.dipoles_in_file},
            {"thinning_error", coil.thinning_error},
            {"notes", coil.notes}};
  json["largest_didt_a_per_us"] =
      coil.dipoles.largest_didt_A_per_us > 0 ? Json(coil.dipoles.largest_didt_A_per_us) : Json();
  if (!report.shows_arrows) return json;
  Json arrows = Json::array();
  for (const auto& arrow : efield::currentArrows(coil.dipoles))
    arrows.push_back({{"place_mm", tenths(arrow.place_mm)},
                      {"along", vectorJson(arrow.along)},
                      {"strength", arrow.strength}});
  json["current_arrows"] = arrows;
  return json;
}

Json regionsJson(const steps::FieldRegions& regions) {
  Json list = Json::array();
  for (const auto& region : regions) {
    Json labels = Json::object();
    for (const auto& [name, ml] : region.by_label) labels[name] = ml;
    list.push_back({{"above_share", region.share},
                    {"cortex_mm2", region.area_mm2},
                    {"ml", region.volume_ml},
                    {"by_label_ml", labels}});
  }
  return list;
}

Json differenceJson(const steps::PoseComparison& compared) {
  return {{"target_v_per_m_at_1_a_per_us", compared.at_target},
          {"other_at_target_v_per_m_at_1_a_per_us", compared.other_at_target},
          {"other_at_its_own_v_per_m_at_1_a_per_us", compared.other_at_its_own},
          {"change_at_target", compared.change()},
          {"maximum_ratio", compared.peak_ratio},
          {"maximum_shift_mm", compared.peak_shift_mm},
          {"correlation", compared.correlation}};
}

Json bestJson(const FieldReport& report) {
  const auto& best = *report.best;
  Json json{{"turned_deg", best.turned_deg},
            {"moved_mm", {best.x_mm, best.y_mm}},
            {"v_per_m_at_1_a_per_us", best.best},
            {"planned_v_per_m_at_1_a_per_us", best.planned},
            {"poses", best.poses},
            {"seconds", report.best_s},
            {"mri_T_target", rowMajor(best.target.mri_T_target)}};
  if (report.best_comparison) json["against_planned"] = differenceJson(*report.best_comparison);
  return json;
}

Json comparisonJson(const steps::FieldComparison& compared) {
  return {{"points", compared.points},
          {"relative_error", compared.relative_error},
          {"scaled", compared.is_scaled},
          {"scale", compared.scale},
          {"maximum_ratio", compared.peak_ratio},
          {"maximum_shift_mm", compared.peak_shift_mm}};
}

Json asJson(const FieldReport& report) {
  const auto& field = report.on_cortex;
  Json json{{"target", report.target.name},
            {"coil", isImported(report) ? Json() : coilJson(report)},
            {"gap_mm", guidance::centreGap_mm(report.target)},
            {"tier", int(report.head->tier())},
            {"model", report.head->inWords()},
            {"usual_relative_error", report.head->usualError()}};
  json["rate_a_per_us"] = report.rate_A_per_us ? Json(*report.rate_A_per_us) : Json();
  json["at_1_a_per_us"] = {{"target_v_per_m", field.at_target.norm()},
                           {"target_vector_v_per_m", vectorJson(field.at_target)},
                           {"along_normal_v_per_m", field.along_normal},
                           {"maximum_v_per_m", field.peak}};
  if (const auto& rate = report.rate_A_per_us)
    json["at_rate"] = {{"target_v_per_m", *rate * field.at_target.norm()},
                       {"along_normal_v_per_m", *rate * field.along_normal},
                       {"maximum_v_per_m", *rate * field.peak}};
  json["normal"] = {{"direction", vectorJson(field.normal.normal)},
                    {"off_radial_deg", field.normal.off_radial_deg},
                    {"has_sulci", report.has_sulci}};
  json["maximum_mm"] = tenths(field.peak_place.mm);
  json["maximum_distance_mm"] = field.peak_distance_mm;
  json["regions"] = report.regions ? regionsJson(*report.regions) : Json();
  json["imported"] = report.imported ? importedJson(*report.imported) : Json();
  if (report.best) json["best"] = bestJson(report);
  if (report.pose_comparison) {
    json["against"] = differenceJson(*report.pose_comparison);
    json["against"]["target"] = report.against;
  }
  if (report.comparison) json["comparison"] = comparisonJson(*report.comparison);
  if (report.without_fluid) json["against_tier_1"] = comparisonJson(*report.without_fluid);
  if (const auto& dose = report.dose)
    json["dose"] = {
        {"hotspot", dose->hotspot}, {"threshold_pct", dose->threshold_pct}, {"output_pct", dose->output_pct}};
  return json;
}

}  // namespace

void printField(const FieldReport& report, bool is_json) {
  if (is_json) return printJson(asJson(report));
  printModel(report);
  printImported(report);
  printStrengths(report);
  printRegions(report);
  printExtras(report);
}

}  // namespace facenav::app
