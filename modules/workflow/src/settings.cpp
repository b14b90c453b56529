#include "facenav/workflow/settings.h"

#include "facenav/casefile/evidence.h"
#include "facenav/core/frame_budget.h"
#include "facenav/core/settings_in_force.h"
#include "facenav/guidance/coil_gap.h"
#include "facenav/guidance/coil_plate.h"
#include "facenav/guidance/mep_map.h"
#include "facenav/head_tracking/identity_model.h"
#include "facenav/head_tracking/search_budget.h"
#include "facenav/head_tracking/skin_detail_limits.h"
#include "facenav/head_tracking/skin_field_model.h"
#include "facenav/head_tracking/step_limits.h"
#include "facenav/links/click_rules.h"
#include "facenav/links/pulse_dead_times.h"
#include "facenav/monitoring/registration_check.h"
#include "facenav/registration/fit_limits.h"
#include "facenav/registration/misfit_prior.h"
#include "facenav/segmentation/brain_growth.h"
#include "facenav/segmentation/head_outline.h"
#include "facenav/segmentation/prior_use.h"
#include "facenav/stereo/shared_error.h"
#include "facenav/stimulation/threshold_rules.h"
#include "facenav/workflow/board_collector.h"
#include "facenav/workflow/camera_placement.h"
#include "facenav/workflow/coil_library.h"
#include "facenav/workflow/expert_pose.h"
#include "facenav/workflow/mep_import.h"
#include "facenav/workflow/session_return.h"
#include "facenav/workflow/verify_rig.h"

namespace facenav::workflow {
namespace {

template <class... Group>
struct Groups {
  static SettingsTable table() { return SettingsTable::of<Group...>(); }
  static void use(const SettingsTable& table) { putInForce<Group...>(table); }
};

using All =
    Groups<segmentation::BrainGrowth, segmentation::PriorUse, segmentation::HeadOutline,
           registration::FitLimits, registration::MisfitPrior, stereo::SharedError,
           head_tracking::SkinDetailLimits, head_tracking::IdentityModel, head_tracking::SkinFieldModel,
           head_tracking::StepLimits, FrameBudget, head_tracking::SearchBudget, guidance::PlateRest,
           guidance::FieldByGap, stimulation::ThresholdRules, links::PulseDeadTimes, links::ClickRules,
           guidance::MepMapOptions, MepImportLimits, casefile::EvidenceRules,
           monitoring::RegistrationCheckRules, ReturnRules, CoilRules, ExpertRules, BoardRules,
           PlacementRules, RigCheckRules>;

}  // namespace

SettingsTable allSettings() { return All::table(); }

SettingsTable settingsFor(const SettingsRequest& request) {
  SettingsTable table = allSettings();
  if (request.file) table.readFile(*request.file);
  for (const std::string& assignment : request.assignments) table.setByText(assignment);
  return table;
}

void useSettings(const SettingsRequest& request) { All::use(settingsFor(request)); }

std::optional<std::string> changedSettingsFinding(const std::string& made) {
  std::string words;
  for (const std::string& setting : changedSettingsInWords()) words += (words.empty() ? "" : ", ") + setting;
  if (words.empty()) return std::nullopt;
  return made + " with changed settings: " + words;
}

}  // namespace facenav::workflow
