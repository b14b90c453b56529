// facenav field CASE --target NAME --coil COIL: the electric field of a planned pose on the cortex; the best
// pose, the comparison with another target's pose or an imported field, and the output by field. The plan is
// not changed; the model of the head is built and kept in the case where it is missing.

#include <chrono>

#include "commands/commands.h"
#include "commands/field_print.h"
#include "facenav/core/error.h"
#include "facenav/core/log.h"
#include "facenav/core/standard_output.h"
#include "facenav/prepare/case_field.h"
#include "typed_values.h"
#include "wrong_usage.h"

namespace facenav::app {
namespace {

struct FieldRequest {
  std::filesystem::path case_folder, case_option, output, compare, surface;
  std::string target, coil, best, hotspot, against;
  std::optional<double> didt_A_per_us, output_pct, threshold_pct;
  std::optional<int> tier;
  bool is_json = false, shows_arrows = false;
};

/// Rate of the current: as typed, or the coil's largest one times the output.
std::optional<double> rateOf(const FieldRequest& request, const efield::CoilDipoles& coil) {
  if (request.didt_A_per_us) return request.didt_A_per_us;
  if (!request.output_pct) return std::nullopt;
  if (coil.largest_didt_A_per_us <= 0)
    throw WrongUsage("the coil's file does not say how fast its current rises at 100 % output",
                     "give --didt in place of --output");
  return coil.largest_didt_A_per_us * *request.output_pct / 100;
}

class FieldSteps {
 public:
  FieldSteps(const FieldRequest& request, Context& context)
      : request_(request),
        is_quiet_(context.is_quiet),
        monitor_(context.monitor),
        store_(casefile::CaseStore::open(request.case_folder.empty() ? request.case_option
                                                                     : request.case_folder)),
        plan_(store_.targets()) {
    report_.target = plan_.find(request.target);
    report_.has_coil = !request.coil.empty();
    if (report_.has_coil) report_.coil = efield::fieldCoil(request.coil);
    report_.rate_A_per_us = rateOf(request, report_.coil.dipoles);
    report_.shows_arrows = request.shows_arrows;
    surfaces_ = steps::fieldSurfaces(store_);
    report_.has_sulci = surfaces_.has_sulci;
    report_.imported = steps::importedField(store_, report_.target);
    if (isImported()) {
      head_ = steps::importedHead(store_, report_.target);
      if (!report_.rate_A_per_us) report_.rate_A_per_us = report_.imported->rate_A_per_us;
    } else {
      if (request.tier != 0) buildShells();
      head_ = headAt(report_.target);
    }
    report_.head = head_.get();
  }

  void run() {
    const auto& coil = report_.coil.dipoles;
    report_.on_cortex = steps::fieldOnCortex(*head_, surfaces_, coil, report_.target);
    const bool is_shown = request_.is_json || !is_quiet_;
    if (is_shown && surfaces_.brain_mask && head_->fillsBrain())
      report_.regions = steps::fieldInBrain(*head_, surfaces_, coil, report_.target, report_.on_cortex,
                                            monitor_, steps::aalLabels(store_))
                            .regions;
    if (head_->tier() == steps::FieldTier::four_shells) compareWithoutFluid();
    if (!request_.best.empty()) findBest();
    if (!request_.against.empty()) compareWith(plan_.find(request_.against));
    if (!request_.hotspot.empty()) findDose();
    if (!request_.compare.empty())
      report_.comparison = steps::compareField(*head_, surfaces_, coil, report_.target, request_.compare,
                                               report_.rate_A_per_us, request_.surface);
    if (!request_.output.empty())
      steps::writeField(*head_, surfaces_, coil, report_.target, report_.rate_A_per_us.value_or(1),
                        request_.output);
    if (is_shown) printField(report_, request_.is_json);
  }

 private:
  bool isImported() const { return request_.tier == int(steps::FieldTier::imported); }

  /// Builds the shells that are wanted if the case can have them and does not: three, or three and four, so
  /// that both are compared.
  void buildShells() const {
    using steps::FieldTier;
    if (!steps::canHaveField(store_)) return;
    const bool wants_fluid = request_.tier == int(FieldTier::four_shells);
    try {
      if (!steps::hasField(store_, FieldTier::three_shells) &&
          (request_.tier || !steps::hasField(store_, FieldTier::four_shells)))
        steps::buildField(store_, monitor_, FieldTier::three_shells);
      if (wants_fluid && !steps::hasField(store_, FieldTier::four_shells))
        steps::buildField(store_, monitor_, FieldTier::four_shells);
    } catch (const Cancelled&) {
      throw;
    } catch (const Error& error) {
      if (request_.tier) throw;
      logWarning(std::string("the local sphere is used: ") + error.what());
    }
  }

  std::unique_ptr<steps::HeadField> headAt(const guidance::Target& target) const {
    std::optional<steps::FieldTier> wanted;
    if (request_.tier) wanted = steps::FieldTier(*request_.tier);
    return steps::headField(store_, surfaces_, steps::coilPoseOf(target), wanted);
  }

  void compareWithoutFluid() {
    if (!steps::hasField(store_, steps::FieldTier::three_shells)) return;
    const auto without = steps::headField(store_, surfaces_, steps::coilPoseOf(report_.target),
                                          steps::FieldTier::three_shells);
    report_.without_fluid =
        steps::compareModels(*head_, *without, surfaces_, report_.coil.dipoles, report_.target);
  }

  void findBest() {
    const auto aim = request_.best == "normal" ? steps::FieldAim::along_normal : steps::FieldAim::strength;
    const auto planned = steps::plannedHead(store_);
    const auto begin = std::chrono::steady_clock::now();
    report_.best = steps::bestPose(*head_, surfaces_, planned, report_.coil.dipoles, report_.target, aim);
    report_.best_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    report_.best_comparison = comparedWith(report_.best->target);
  }

  steps::PoseComparison comparedWith(const guidance::Target& other) const {
    return steps::comparePoses(*head_, *headAt(other), surfaces_, report_.coil.dipoles, report_.target,
                               other);
  }

  void compareWith(const guidance::Target& other) {
    report_.against = other.name;
    report_.pose_comparison = comparedWith(other);
  }

  void findDose() {
    const auto& hotspot = plan_.find(request_.hotspot);
    const Eigen::Matrix3Xd place = hotspot.cortex_point.mm;
    const double there = headAt(hotspot)->at(report_.coil.dipoles, steps::coilPoseOf(hotspot), place).norm();
    const double here = report_.on_cortex.at_target.norm();
    report_.dose = {hotspot.name, *request_.threshold_pct,
                    steps::doseByField_pct(there, here, *request_.threshold_pct)};
  }

  const FieldRequest& request_;
  bool is_quiet_;
  TaskMonitor& monitor_;
  casefile::CaseStore store_;
  guidance::TreatmentPlan plan_;
  steps::FieldSurfaces surfaces_;
  std::unique_ptr<steps::HeadField> head_;
  FieldReport report_;
};

/// Throws WrongUsage for options that fit neither a computed nor an imported field.
void requireSensible(const FieldRequest& request) {
  const bool is_imported = request.tier == int(steps::FieldTier::imported);
  if (request.coil.empty() && !is_imported)
    throw WrongUsage("--coil is required", "give figure8-70, round, or a coil's file; or --tier 3");
  if (is_imported && !(request.best.empty() && request.hotspot.empty() && request.against.empty()))
    throw WrongUsage("an imported field is that of one pose: --best, --against and --hotspot need others",
                     "leave them out, or use another --tier");
}

void addFieldOptions(CLI::App& verb, FieldRequest& request) {
  verb.add_option("CASE", request.case_folder, "case folder");
  verb.add_option("--case", request.case_option, "the same, as an option");
  verb.add_option("--target", request.target, "target of the plan whose pose is taken")->required();
  verb.add_option("--coil", request.coil,
                  "the coil's field: figure8-70 or round (built in), or a .ccd, .tcd, .nii.gz file; an "
                  "imported field needs none");
  auto* didt = verb.add_option("--didt", request.didt_A_per_us, "rate of the coil's current, A/us")
                   ->check(CLI::Range(0.001, 1000.0));
  verb.add_option("--output", request.output_pct,
                  "% of the stimulator's output, where the coil's file gives its largest rate")
      ->check(CLI::Range(0.1, 100.0))
      ->excludes(didt);
  verb.add_option(
          "--tier", request.tier,
          "head model: 0 local sphere, 1 three shells, 2 with the fluid round the brain (built once, about a "
          "minute, 2 GB), 3 the field that was imported for this pose (facenav import); default: the surest "
          "of 0 to 2")
      ->check(CLI::Range(0, 3));
  verb.add_option(
      "-o,--output-file", request.output,
      "writes the field (V/m, at 1 A/us if no rate is given): .vtp or .msh on the cortex, .nii.gz in "
      "the brain");
  auto* compare = verb.add_option(
      "--compare", request.compare,
      "field of another program on the same cortex (.msh, NIfTI, .vtp, values on a surface): relative error, "
      "shift of the maximum");
  verb.add_option("--surface", request.surface, "of --compare with values on a surface: its GIFTI file")
      ->needs(compare);
  verb.add_option(
          "--best", request.best,
          "finds handle angle and place within 2 x 2 cm for the most field: strength (at the target), normal "
          "(along the normal of its cortex); the plan stays")
      ->check(CLI::IsMember({"strength", "normal"}));
  verb.add_option("--against", request.against,
                  "another target of the plan: how the field of its pose differs from this one");
  auto* hotspot =
      verb.add_option("--hotspot", request.hotspot, "target of the motor hotspot, for the dose by field");
  auto* threshold =
      verb.add_option("--threshold", request.threshold_pct, "motor threshold at the hotspot, % of the output")
          ->check(CLI::Range(1.0, 100.0))
          ->needs(hotspot);
  hotspot->needs(threshold);
  auto* json = verb.add_flag("--json", request.is_json, "as JSON");
  verb.add_flag("--arrows", request.shows_arrows,
                "with --json: the direction of the coil's current as arrows")
      ->needs(json);
}

}  // namespace

void addField(CLI::App& app, Context& context) {
  auto* verb = app.add_subcommand(
      "field", "the electric field of a planned pose on the cortex, its best pose, and the output by field");
  auto request = std::make_shared<FieldRequest>();
  addFieldOptions(*verb, *request);
  verb->callback([&context, request] {
    if (request->case_folder.empty() && request->case_option.empty()) throw CLI::RequiredError("CASE");
    if (!request->case_folder.empty() && !request->case_option.empty())
      throw WrongUsage("the case is given twice", "give CASE or --case");
    requireSensible(*request);
    if (isStandardOutput(request->output))
      throw WrongUsage("the field's format is told by the file's name", "give a name such as E.vtp");
    if (!request->output.empty() && !steps::isFieldName(request->output))
      throw WrongUsage("'" + request->output.string() + "' is no name of a field",
                       "write .vtp, .msh, .nii or .nii.gz");
    FieldSteps(*request, context).run();
  });
}

}  // namespace facenav::app
