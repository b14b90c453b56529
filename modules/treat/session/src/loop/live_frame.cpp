#include "facenav/session/live_frame.h"

namespace facenav::session {
namespace {

/// Word of OpenIGTLink's metadata TransformStatus.
std::string statusWord(LostReason reason) {
  switch (reason) {
    case LostReason::no_face:
    case LostReason::no_marker:
      return "OUT_OF_VIEW";
    case LostReason::camera:
    case LostReason::stale:
      return "MISSING";
    default:
      return "INVALID";
  }
}

links::LivePose found(const char* name, const Eigen::Isometry3d& pose) { return {name, pose, "OK"}; }
links::LivePose lost(const char* name, LostReason reason) { return {name, std::nullopt, statusWord(reason)}; }

/// A pose that needs both head and coil.
template <class Pose>
links::LivePose ofBoth(const char* name, const NavigationState& state, Pose pose) {
  if (!state.camera_T_mri) return lost(name, state.camera_T_mri.reason());
  if (!state.camera_T_coil) return lost(name, state.camera_T_coil.reason());
  const RigidTransform<Mri, Coil> mri_T_coil = state.camera_T_mri->inverse() * *state.camera_T_coil;
  return found(name, pose(mri_T_coil).isometry());
}

std::chrono::system_clock::time_point utcOf(Timestamp steady) {
  const std::chrono::duration<double> age(Timestamp::now() - steady);
  return std::chrono::system_clock::now() -
         std::chrono::duration_cast<std::chrono::system_clock::duration>(age);
}

void addAligned(const NavigationState& state, std::vector<links::LivePose>& poses) {
  if (state.head && state.camera_T_mri)
    poses.push_back(
        found("SubjectToMri", (state.camera_T_mri->inverse() * state.head->camera_T_head).isometry()));
  else
    poses.push_back(
        lost("SubjectToMri", state.camera_T_mri ? state.head.reason() : state.camera_T_mri.reason()));
  poses.push_back(ofBoth("CoilToMri", state, [](const auto& mri_T_coil) { return mri_T_coil; }));
  if (!state.chosen) return poses.push_back(lost("CoilToTarget", LostReason::stale));
  poses.push_back(ofBoth("CoilToTarget", state, [&](const auto& mri_T_coil) {
    return state.chosen->target.mri_T_target.inverse() * mri_T_coil;
  }));
}

}  // namespace

links::LiveFrame liveFrameOf(const NavigationState& state) {
  links::LiveFrame frame;
  frame.number = state.frame;
  frame.utc = utcOf(state.taken);
  frame.state = guidance::toString(state.guidance.state);
  frame.instruction = state.guidance.instruction;
  frame.target = state.target;
  frame.poses.push_back(state.head ? found("SubjectToTracker", state.head->camera_T_head.isometry())
                                   : lost("SubjectToTracker", state.head.reason()));
  frame.poses.push_back(state.camera_T_coil ? found("Coil1ToTracker", state.camera_T_coil->isometry())
                                            : lost("Coil1ToTracker", state.camera_T_coil.reason()));
  if (state.chosen) frame.mri_T_target = state.chosen->target.mri_T_target.isometry();
  if (state.is_aligned) addAligned(state, frame.poses);
  if (const auto& values = state.guidance.values)
    frame.guidance = links::LiveGuidance{values->distance_mm, values->lateral_mm, values->depth_mm,
                                         values->tilt_rad * kDegPerRad, values->twist_rad * kDegPerRad};
  return frame;
}

}  // namespace facenav::session
