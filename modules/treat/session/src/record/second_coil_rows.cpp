#include "second_coil_rows.h"

namespace facenav::session {

void logSecondCoil(const NavigationState& state, bool is_paused, casefile::SessionLog& log) {
  if (!state.second) return;
  const auto& second = *state.second;
  const double t_s = state.captured.s;
  log.addSecond(casefile::poseRow(state.frame, t_s, casefile::PoseObject::head, state.camera_T_mri),
                second.name);
  log.addSecond(casefile::poseRow(state.frame, t_s, casefile::PoseObject::coil, second.camera_T_coil),
                second.name);
  if (!second.chosen || is_paused) return;
  guidance::GuidanceRow row{state.frame, t_s, second.chosen->target.name, second.guidance, {}};
  row.gap.by_poses_mm = second.gap_mm;
  log.addSecond(row, second.name);
}

}  // namespace facenav::session
