#include "settings.h"

#include "facenav/casefile/evidence.h"
#include "facenav/coil_library/coil_library.h"
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
#include "facenav/health/verify_rig.h"
#include "facenav/links/click_rules.h"
#include "facenav/links/pulse_dead_times.h"
#include "facenav/monitoring/registration_check.h"
#include "facenav/plan/expert_pose.h"
#include "facenav/registration/fit_limits.h"
#include "facenav/registration/misfit_prior.h"
#include "facenav/review/mep_import.h"
#include "facenav/segmentation/brain_growth.h"
#include "facenav/segmentation/head_outline.h"
#include "facenav/segmentation/prior_use.h"
#include "facenav/setup/board_collector.h"
#include "facenav/setup/camera_placement.h"
#include "facenav/stereo/shared_error.h"
#include "facenav/stimulation/threshold_rules.h"
#include "facenav/treat/session_return.h"

namespace facenav::app {
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
           guidance::MepMapOptions, steps::MepImportLimits, casefile::EvidenceRules,
           monitoring::RegistrationCheckRules, steps::ReturnRules, coil_library::CoilRules,
           steps::ExpertRules, steps::BoardRules, steps::PlacementRules, health::RigCheckRules>;

}  // namespace

SettingsTable allSettings() { return All::table(); }

SettingsTable settingsFor(const SettingsRequest& request) {
  SettingsTable table = allSettings();
  if (request.file) table.readFile(*request.file);
  for (const std::string& assignment : request.assignments) table.setByText(assignment);
  return table;
}

void useSettings(const SettingsRequest& request) { All::use(settingsFor(request)); }

}  // namespace facenav::app
