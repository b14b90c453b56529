#pragma once
// `facenav target CASE --from-session S [--pulse N]`: the expert's pose as a target.

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "context.h"
#include "facenav/casefile/case_store.h"

namespace facenav::app {

struct ExpertTargetRequest {
  bool is_wanted = false;
  std::string session, from_target, by;
  std::optional<int> pulse;
};

void addExpertOptions(CLI::App& verb, ExpertTargetRequest& request);
/// Stores the target. `name`: its name; empty: "expert " and the old target's name. Throws Error as
/// steps::storeExpertPose does.
void storeExpertTarget(Context& context, const casefile::CaseStore& store, const ExpertTargetRequest& request,
                       const std::string& name, bool is_json);

}  // namespace facenav::app
