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

/// A coil as it is sent.
struct SentCoil {
  const char *to_tracker, *to_mri, *to_target;  // names of its poses
  const std::string& name;
  const Tracked<RigidTransform<Camera, Coil>>& camera_T_coil;
  const std::shared_ptr<const ChosenTarget>& chosen;
};

/// A pose that needs both head and coil.
template <class Pose>
links::LivePose ofBoth(const char* name, const NavigationState& state, const SentCoil& coil, Pose pose) {
  if (!state.camera_T_mri) return lost(name, state.camera_T_mri.reason());
  if (!coil.camera_T_coil) return lost(name, coil.camera_T_coil.reason());
  const RigidTransform<Mri, Coil> mri_T_coil = state.camera_T_mri->inverse() * *coil.camera_T_coil;
  return found(name, pose(mri_T_coil).isometry());
}

std::chrono::system_clock::time_point utcOf(Timestamp steady) {
  const std::chrono::duration<double> age(Timestamp::now() - steady);
  return std::chrono::system_clock::now() -
         std::chrono::duration_cast<std::chrono::system_clock::duration>(age);
}

void addTracked(const SentCoil& coil, std::vector<links::LivePose>& poses) {
  poses.push_back(coil.camera_T_coil ? found(coil.to_tracker, coil.camera_T_coil->isometry())
                                     : lost(coil.to_tracker, coil.camera_T_coil.reason()));
  poses.back().coil = coil.name;
}

void addAligned(const NavigationState& state, const SentCoil& coil, std::vector<links::LivePose>& poses) {
  poses.push_back(ofBoth(coil.to_mri, state, coil, [](const auto& mri_T_coil) { return mri_T_coil; }));
  poses.back().coil = coil.name;
  poses.push_back(coil.chosen ? ofBoth(coil.to_target, state, coil,
                                       [&](const auto& mri_T_coil) {
                                         return coil.chosen->target.mri_T_target.inverse() * mri_T_coil;
                                       })
                              : lost(coil.to_target, LostReason::stale));
  poses.back().coil = coil.name;
}

void addAlignedHead(const NavigationState& state, std::vector<links::LivePose>& poses) {
  if (state.head && state.camera_T_mri)
    poses.push_back(
        found("SubjectToMri", (state.camera_T_mri->inverse() * state.head->camera_T_head).isometry()));
  else
    poses.push_back(
        lost("SubjectToMri", state.camera_T_mri ? state.head.reason() : state.camera_T_mri.reason()));
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
  if (state.chosen) frame.mri_T_target = state.chosen->target.mri_T_target.isometry();
  const SentCoil first{"Coil1ToTracker", "CoilToMri",         "CoilToTarget",
                       state.coil_name,  state.camera_T_coil, state.chosen};
  addTracked(first, frame.poses);
  if (state.is_aligned) {
    addAlignedHead(state, frame.poses);
    addAligned(state, first, frame.poses);
  }
  if (state.second) {
    const SentCoil second{
        "Coil2ToTracker",    "Coil2ToMri", "Coil2ToTarget", state.second->name, state.second->camera_T_coil,
        state.second->chosen};
    addTracked(second, frame.poses);
    if (state.is_aligned) addAligned(state, second, frame.poses);
  }
  if (const auto& values = state.guidance.values)
    frame.guidance = links::LiveGuidance{values->distance_mm, values->lateral_mm, values->depth_mm,
                                         values->tilt_rad * kDegPerRad, values->twist_rad * kDegPerRad};
  return frame;
}

}  // namespace facenav::session
