#include "facenav/home/home_advice.h"

#include <cmath>
#include <set>

#include "facenav/coil_tracking/visible_markers.h"
#include "facenav/core/number_text.h"
#include "facenav/geometry/rotation.h"

namespace facenav::steps {
namespace {

using head_tracking::LossDetail;

constexpr double kLookEvery_s = 0.5;

HomeAdvice refused(HomeStep step, const std::string& words) { return {step, HomeSign::none, 0, words, true}; }

HomeAdvice camerasAdvice(const session::NavigationState& state) {
  if (session::isCameraAway(state))
    return {HomeStep::sit, HomeSign::none, 0, "A camera is gone: plug it in again, and wait.", false};
  const auto fault = session::rigFault(state)->state;
  const bool has_moved = fault == health::RigState::moved || fault == health::RigState::other_cameras;
  return refused(HomeStep::sit, has_moved
                                    ? "The cameras were moved: stop, and call the clinic."
                                    : "The two cameras do not work together: stop, and call the clinic.");
}

HomeAdvice headAdvice(const session::NavigationState& state) {
  if (state.withheld && state.withheld->isOfAlignment())
    return refused(HomeStep::sit, "The face no longer fits its first measurement: finish, and start again.");
  switch (state.head_detail) {
    case LossDetail::other_face:
      return refused(HomeStep::sit, "This is not the person whose face is stored: stop.");
    case LossDetail::covered:
      return {HomeStep::sit, HomeSign::none, 0, "Your face is hidden: move hand and coil aside.", false};
    case LossDetail::too_far:
      return {HomeStep::sit, HomeSign::none, 0, "You sit too far away: come nearer to the cameras.", false};
    case LossDetail::frozen:
    case LossDetail::no_picture:
      return refused(HomeStep::sit, "A camera gives no picture: check its cable.");
    default:
      return {HomeStep::sit, HomeSign::none, 0, "Sit still and look at the cameras: your face is not seen.",
              false};
  }
}

HomeSign tiltSign(const guidance::GuidanceValues& values) {
  const Eigen::Vector2d& tilt = values.tilt_in_coil_rad;
  if (std::abs(tilt.x()) >= std::abs(tilt.y()))
    return tilt.x() > 0 ? HomeSign::raise_handle : HomeSign::raise_front;
  return tilt.y() > 0 ? HomeSign::raise_left : HomeSign::raise_right;
}

const char* sideWords(HomeSign sign) {
  switch (sign) {
    case HomeSign::raise_left:
      return "its left side";
    case HomeSign::raise_right:
      return "its right side";
    case HomeSign::raise_handle:
      return "the handle";
    default:
      return "its front, away from the handle";
  }
}

std::string millimetres(double mm) {
  return formatted("%ld\u00a0mm", std::max(1L, std::lround(std::abs(mm))));
}
std::string degreesOf(double rad) {
  return formatted("%ld\u00b0", std::max(1L, std::lround(std::abs(rad) * kDegPerRad)));
}

HomeAdvice guidedAdvice(const guidance::GuidanceState& guidance) {
  HomeAdvice advice{HomeStep::follow, HomeSign::none, 0, {}, false};
  const auto& values = *guidance.values;
  switch (guidance.action) {
    case guidance::Action::hold:
      advice.sign = HomeSign::hold;
      advice.words = "Good: hold the coil still.";
      return advice;
    case guidance::Action::move:
      advice.sign = HomeSign::arrow;
      // The coil's +x is on the left of a person behind the handle, its +y ahead.
      advice.arrow_rad = std::atan2(-values.lateral_in_coil_mm.x(), values.lateral_in_coil_mm.y());
      advice.words =
          "Slide the coil along the head, as the arrow points: " + millimetres(values.lateral_mm) + ".";
      return advice;
    case guidance::Action::lift:
      advice.sign = HomeSign::lift;
      advice.words = "Lift the coil a little: " + millimetres(values.depth_mm) + ".";
      return advice;
    case guidance::Action::press:
      advice.sign = HomeSign::press;
      advice.words = "Bring the coil closer to the head: " + millimetres(values.depth_mm) + ".";
      return advice;
    case guidance::Action::tilt:
      advice.sign = tiltSign(values);
      advice.words = std::string("Tilt the coil: raise ") + sideWords(advice.sign) + ", " +
                     degreesOf(values.tilt_rad) + ".";
      return advice;
    case guidance::Action::turn:
      advice.sign = values.twist_rad > 0 ? HomeSign::turn_counterclockwise : HomeSign::turn_clockwise;
      advice.words = std::string("Turn the coil like a key, ") +
                     (values.twist_rad > 0 ? "to the left: " : "to the right: ") +
                     degreesOf(values.twist_rad) + ".";
      return advice;
    case guidance::Action::none:
      break;
  }
  return advice;
}

bool has(const std::string& text, const char* part) { return text.find(part) != std::string::npos; }

std::set<int> printsOf(const coil_tracking::CoilModel& coil, const std::string& dictionary) {
  std::set<int> ids;
  for (const auto& marker : coil.markers)
    if (!marker.pattern && marker.dictionary == dictionary) ids.insert(marker.id);
  return ids;
}

/// True if both pictures show a print that the coil does not carry, and none of its own.
bool showOtherCoil(const cameras::StereoFrame& frame, const coil_tracking::CoilModel& coil) {
  const auto& first = coil.markers.front();
  const std::string dictionary = first.pattern ? std::string("4x4_50") : first.dictionary;
  const auto own = printsOf(coil, dictionary);
  const auto left = coil_tracking::visibleMarkers(frame.left, dictionary),
             right = coil_tracking::visibleMarkers(frame.right, dictionary);
  bool shows_other = false;
  for (const int id : left) {
    if (own.count(id)) return false;
    shows_other = shows_other || right.count(id);
  }
  return shows_other;
}

}  // namespace

HomeAdvice homeAdvice(const session::NavigationState& state, bool sees_other_coil) {
  if (!state.failure.empty())
    return refused(HomeStep::sit, "The program stopped: finish, and call the clinic.");
  if (session::rigFault(state)) return camerasAdvice(state);
  if (!state.camera_T_mri) return headAdvice(state);
  if (!state.camera_T_coil && sees_other_coil)
    return refused(HomeStep::hold, "This is not the coil of the treatment: take the right one.");
  if (!state.camera_T_coil)
    return {HomeStep::hold, HomeSign::none, 0, "Hold the coil so that its printed marker faces the cameras.",
            false};
  if (!state.guidance.values) return {HomeStep::follow, HomeSign::none, 0, "Wait a moment.", false};
  return guidedAdvice(state.guidance);
}

std::string homeRefusal(const Error& error) {
  const std::string words = error.what();
  if (has(words, "the stored face was measured without"))
    return "The clinic measured this face without the coil's marker: switch the projector on, or ask the "
           "clinic "
           "for a new file.";
  const bool lacks_marker = has(words, "no picture was taken") || has(words, "the face alone does not show");
  if (lacks_marker && !has(words, "does not fit"))
    return "Hold the coil still beside the face, its printed marker to both cameras, and try again.";
  if (!lacks_marker && (has(words, "does not fit") || has(words, "mirror")))
    return "This face is not the stored one: only that person can be treated.";
  if (has(words, "shows none") || has(words, "no dots"))
    return "The dots are not seen on the face: switch the projector on, and try again.";
  if (has(words, "too little") || has(words, "nothing like a face") || has(words, "no face") ||
      has(words, "ambiguous") || has(words, "no point of a face"))
    return "Too little of the face is seen: move hair and hands aside, look at the cameras, and try again.";
  if (has(words, "moved") || has(words, "calibrat") || has(words, "camera"))
    return "The cameras were moved or changed: do not treat, and call the clinic.";
  return words;
}

OtherCoilWatch::OtherCoilWatch(const coil_tracking::CoilModel& coil) : coil_(coil) {}

bool OtherCoilWatch::sees(const session::NavigationState& state) {
  const Timestamp now = Timestamp::now();
  if (look_.valid() && look_.wait_for(std::chrono::seconds(0)) == std::future_status::ready)
    sees_ = look_.get();
  if (state.camera_T_coil) sees_ = false;
  if (look_.valid() || state.camera_T_coil || !state.images || now - looked_ < kLookEvery_s) return sees_;
  looked_ = now;
  look_ = std::async(std::launch::async,
                     [frame = state.images, coil = coil_] { return showOtherCoil(*frame, coil); });
  return sees_;
}

}  // namespace facenav::steps
