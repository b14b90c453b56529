#include "facenav/session/navigation_state.h"

#include "facenav/core/number_text.h"

namespace facenav::session {
namespace {

using head_tracking::LossDetail;

std::string detailWords(LossDetail detail) {
  switch (detail) {
    case LossDetail::not_found:
      return "FACE NOT FOUND: turn the face towards the cameras";
    case LossDetail::covered:
      return "FACE COVERED OR TURNED AWAY: move coil and hand aside, face the cameras";
    case LossDetail::too_far:
      return "FACE TOO FAR AWAY: come nearer to the cameras";
    case LossDetail::blurred:
      return "PICTURE BLURRED: hold still, check focus";
    case LossDetail::one_camera:
      return "ONE CAMERA DOES NOT SEE THE FACE: clear its view";
    case LossDetail::frozen:
      return "CAMERA FROZEN: its picture repeats";
    case LossDetail::no_picture:
      return "NO PICTURE: check both cameras and the light";
    case LossDetail::swapped:
      return monitoring::bannerOf(health::RigState::swapped);
    case LossDetail::out_of_step:
      return monitoring::bannerOf(health::RigState::out_of_step);
    case LossDetail::cameras_moved:
      return monitoring::bannerOf(health::RigState::moved);
    case LossDetail::cameras_disagree:
      return monitoring::bannerOf(health::RigState::disagree);
    case LossDetail::other_face:
      return "ANOTHER PERSON: only the patient's face is followed";
    case LossDetail::doubtful:
    case LossDetail::unknown:
      break;
  }
  return {};
}

constexpr const char* kHeadNotServed = "HEAD NOT SEEN: show its marker to the tracker";
constexpr const char* kCoilNotServed = "COIL NOT SEEN: show its marker to the tracker";

std::string headWords(LostReason reason, LossDetail detail, bool is_served) {
  if (is_served && reason == LostReason::no_face) return kHeadNotServed;
  const std::string words = detailWords(detail);
  if (!words.empty()) return words;
  switch (reason) {
    case LostReason::no_face:
      return "FACE NOT SEEN: turn the face towards the cameras";
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

std::string coilWords(LostReason reason, bool is_served) {
  if (is_served && reason == LostReason::no_marker) return kCoilNotServed;
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

std::string tooUncertainInWords(const ChosenTarget& chosen) {
  constexpr double kBound = 1.96;  // standard errors, where no bound is known
  const double bound_mm =
      chosen.error_bound_mm > 0 ? chosen.error_bound_mm : kBound * chosen.predicted_error_mm;
  if (bound_mm <= kMostErrorBound_mm) return {};
  return formatted("alignment too uncertain (95 %% within %.1f mm, %.1f allowed): align again", bound_mm,
                   kMostErrorBound_mm);
}

std::optional<health::RigVerdict> rigFault(const NavigationState& state) {
  if (!state.withheld || !state.withheld->isOfCameras()) return std::nullopt;
  return state.withheld->rig;
}

bool isCameraAway(const NavigationState& state) {
  const auto fault = rigFault(state);
  return fault && fault->state == health::RigState::away;
}

NavigationState blanked(const NavigationState& state, LostReason reason) {
  NavigationState out = state;
  out.head = Lost{reason};
  out.coil = Lost{reason};
  out.camera_T_mri = Lost{reason};
  out.camera_T_coil = Lost{reason};
  out.head_detail = LossDetail::unknown;  // it belongs to an earlier frame
  out.gap = {};
  out.guidance = {};
  out.guidance.reason = reason;
  out.guidance.instruction = lossInWords(out);
  if (!out.second) return out;
  out.second->coil = Lost{reason};
  out.second->camera_T_coil = Lost{reason};
  out.second->gap_mm.reset();
  out.second->guidance = {};
  out.second->guidance.reason = reason;
  out.second->guidance.instruction = out.guidance.instruction;
  return out;
}

std::string lossWord(const NavigationState& state) {
  if (state.head) return {};
  return state.withheld ? monitoring::wordOf(*state.withheld) : toString(state.head_detail);
}

std::string lossInWords(const NavigationState& state) {
  if (!state.failure.empty()) return "STOPPED: " + state.failure;
  if (state.withheld) return monitoring::bannerOf(*state.withheld);
  if (!state.head) return headLossInWords(state);
  if (!state.is_aligned) return "NOT ALIGNED: align the head first";
  if (!state.camera_T_mri)
    return headWords(state.camera_T_mri.reason(), state.head_detail, state.is_head_served);
  return coilLossInWords(state);
}

std::string headLossInWords(const NavigationState& state) {
  return state.head ? std::string() : headWords(state.head.reason(), state.head_detail, state.is_head_served);
}

std::string coilLossInWords(const NavigationState& state) {
  return state.coil ? std::string() : coilWords(state.coil.reason(), state.is_coil_served);
}

std::string secondCoilLossInWords(const NavigationState& state) {
  if (!state.second || state.second->coil) return {};
  return coilWords(state.second->coil.reason(), state.is_head_served);  // then both coils are
}

std::vector<std::string> lossTitles(const NavigationState& state) {
  const auto title = [](const std::string& words) { return words.substr(0, words.find(':')); };
  std::vector<std::string> titles;
  for (const std::string& words : {headLossInWords(state), coilLossInWords(state)})
    if (!words.empty() && (titles.empty() || titles.back() != title(words))) titles.push_back(title(words));
  return titles;
}

}  // namespace facenav::session
