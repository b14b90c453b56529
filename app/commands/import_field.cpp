#include "commands/import_field.h"

#include <cstdio>

#include "facenav/core/number_text.h"
#include "facenav/geometry/json_transform.h"
#include "json_output.h"
#include "wrong_usage.h"

namespace facenav::app {

void addImportFieldOptions(CLI::App& verb, ImportFieldRequest& request) {
  verb.add_option("--target", request.order.target,
                  "of an electric field (.msh, NIfTI, overlay): the target for whose pose it was computed");
  verb.add_option("--didt", request.order.rate_A_per_us,
                  "of an electric field: the rate of the current that it is for, A/us; default 1, as SimNIBS")
      ->check(CLI::Range(0.001, 1000.0));
  verb.add_option("--surface", request.order.surface,
                  "of an electric field's overlay: the GIFTI surface that its values belong to");
}

std::string inLines(const steps::ImportedField& field) {
  const auto& p = field.peak_place.mm;
  std::string lines = formatted(
      "imported     maximum %.3g V/m, 99.9th percentile %.3g V/m at %g A/us in its own %s, at RAS "
      "%.1f %.1f %.1f mm\n",
      field.peak, field.percentile_99_9, field.rate_A_per_us, field.fills_brain ? "brain" : "surface", p.x(),
      p.y(), p.z());
  lines += "             " + field.words + "\n";
  for (const auto& note : field.notes) lines += "note: " + note + "\n";
  return lines;
}

nlohmann::ordered_json importedJson(const steps::ImportedField& field) {
  return {{"target", field.target},
          {"words", field.words},
          {"rate_a_per_us", field.rate_A_per_us},
          {"maximum_v_per_m", field.peak},
          {"percentile_99_9_v_per_m", field.percentile_99_9},
          {"maximum_mm", rowMajor(field.peak_place)},
          {"has_directions", field.has_directions},
          {"fills_brain", field.fills_brain},
          {"notes", field.notes}};
}

void importFieldFile(const Context& context, const std::filesystem::path& case_folder,
                     const ImportFieldRequest& request) {
  if (request.order.target.empty())
    throw WrongUsage("an electric field belongs to the pose of one target",
                     "give --target with the target's name");
  const auto store = casefile::CaseStore::open(case_folder);
  const auto field = request.is_dry_run ? steps::previewField(store, request.order)
                                        : steps::importField(store, request.order);
  if (request.is_json) {
    auto json = importedJson(field);
    json["imported"] = !request.is_dry_run;
    return printJson(json);
  }
  if (context.is_quiet) return;
  std::printf("%s", inLines(field).c_str());
  if (!request.is_dry_run)
    std::printf("kept with the target '%s': facenav field --tier 3, and Plan's menu Field\n",
                field.target.c_str());
}

}  // namespace facenav::app
