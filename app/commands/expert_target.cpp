#include "commands/expert_target.h"

#include <cstdio>

#include "facenav/core/log.h"
#include "facenav/geometry/json_transform.h"
#include "facenav/plan/expert_pose.h"
#include "json_output.h"

namespace facenav::app {

void addExpertOptions(CLI::App& verb, ExpertTargetRequest& request) {
  auto* session = verb.add_option_function<std::string>(
      "--from-session",
      [&request](const std::string& name) { request.is_wanted = true, request.session = name; },
      "the target is where the coil was held in this session (its name, how it begins, or 'newest'): the "
      "median over the pulses on target");
  verb.add_option("--pulse", request.pulse, "with --from-session: this pulse alone")->needs(session);
  verb.add_option("--of-target", request.from_target,
                  "with --from-session: pulses at this target; default: the one with the most pulses on it")
      ->needs(session);
  verb.add_option("--by", request.by, "with --from-session: who says so; kept with the target")
      ->needs(session);
}

void storeExpertTarget(Context& context, const casefile::CaseStore& store, const ExpertTargetRequest& request,
                       const std::string& name, bool is_json) {
  steps::ExpertRequest order;
  order.session = request.session == "newest" ? "" : request.session;
  order.pulse = request.pulse;
  order.from_target = request.from_target;
  order.name = name;
  order.by = request.by;
  const auto caution = steps::outsideCaution(store, order);
  const auto target = steps::storeExpertPose(store, order);
  const auto& expert = *target.expert;
  if (caution) logWarning(*caution);
  if (is_json) {
    nlohmann::ordered_json json{{"name", target.name},
                                {"session", expert.session},
                                {"pulses", expert.pulses},
                                {"spread_mm", expert.spread_mm},
                                {"spread_deg", expert.spread_deg},
                                {"predicted_error_mm", expert.predicted_error_mm},
                                {"coil", expert.coil},
                                {"mri_T_target", rowMajor(target.mri_T_target)}};
    if (caution) json["caution"] = *caution;
    return printJson(json);
  }
  if (!context.is_quiet)
    std::printf("target '%s': %s\n", target.name.c_str(), steps::inWords(expert).c_str());
}

}  // namespace facenav::app
