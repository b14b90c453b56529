#include "facenav/session/navigation_state.h"

namespace facenav::session {
namespace {

std::string headWords(LostReason reason) {
  switch (reason) {
    case LostReason::no_face:
      return "FACE NOT SEEN: let the face look towards the cameras";
    case LostReason::few_features:
      return "FACE HIDDEN: move the coil or hand aside";
    case LostReason::high_residual:
      return "FACE DOUBTFUL: hold still, look towards the cameras";
    case LostReason::camera:
      return "CAMERA FAULT: check both cameras";
    case LostReason::stale:
      return "NO NEW IMAGES: check the cameras";
    case LostReason::no_marker:
      break;
  }
  return "HEAD LOST";
}

std::string coilWords(LostReason reason) {
  switch (reason) {
    case LostReason::no_marker:
      return "COIL NOT SEEN: turn the marker towards the cameras";
    case LostReason::high_residual:
      return "COIL DOUBTFUL: show the whole marker to both cameras";
    case LostReason::camera:
      return "CAMERA FAULT: check both cameras";
    case LostReason::stale:
      return "NO NEW IMAGES: check the cameras";
    case LostReason::no_face:
    case LostReason::few_features:
      break;
  }
  return "COIL LOST";
}

}  // namespace

NavigationState blanked(const NavigationState& state, LostReason reason) {
  NavigationState out = state;
  out.head = Lost{reason};
  out.coil = Lost{reason};
  out.camera_T_mri = Lost{reason};
  out.camera_T_coil = Lost{reason};
  out.guidance = {};
  out.guidance.reason = reason;
  out.guidance.instruction = lossInWords(out);
  return out;
}

std::string lossInWords(const NavigationState& state) {
  if (!state.failure.empty()) return "STOPPED: " + state.failure;
  if (!state.rig_fault.empty()) return "CAMERAS MOVED: calibrate them again";
  if (state.has_drifted) return "DRIFT: the face no longer matches the MRI, align again";
  if (!state.head) return headWords(state.head.reason());
  if (!state.is_aligned) return "NOT ALIGNED: align the head first";
  if (!state.camera_T_mri) return headWords(state.camera_T_mri.reason());
  if (!state.coil) return coilWords(state.coil.reason());
  return {};
}

}  // namespace facenav::session
