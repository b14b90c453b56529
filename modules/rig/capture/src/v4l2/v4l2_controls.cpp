#include "v4l2_controls.h"

#include <linux/videodev2.h>

#include <array>
#include <cmath>

#include "facenav/core/number_text.h"

namespace facenav::capture {
namespace {

using Lock = ControlState::Lock;

struct ControlPlan {
  const char *name, *unit;
  std::uint32_t automatic, value;  // control numbers
  int manual;                      // value of `automatic` that switches it off
  double unit_per_step;            // unit of `value`
  bool matters_if_absent;          // true: without the control, the camera may adjust itself unnoticed
  std::optional<double> CameraSettings::*wanted;
};

const std::array<ControlPlan, 4> kControls = {{
    {"exposure", "ms", V4L2_CID_EXPOSURE_AUTO, V4L2_CID_EXPOSURE_ABSOLUTE, V4L2_EXPOSURE_MANUAL, 0.1, true,
     &CameraSettings::exposure_ms},
    {"gain", "", V4L2_CID_AUTOGAIN, V4L2_CID_GAIN, 0, 1.0, false, &CameraSettings::gain},
    {"focus", "", V4L2_CID_FOCUS_AUTO, V4L2_CID_FOCUS_ABSOLUTE, 0, 1.0, false, &CameraSettings::focus},
    {"white balance", "K", V4L2_CID_AUTO_WHITE_BALANCE, V4L2_CID_WHITE_BALANCE_TEMPERATURE, 0, 1.0, false,
     &CameraSettings::white_balance_k},
}};

std::optional<v4l2_queryctrl> rangeOf(V4l2Device& device, std::uint32_t id) {
  v4l2_queryctrl query = {};
  query.id = id;
  if (device.ask(VIDIOC_QUERYCTRL, &query) < 0 || (query.flags & V4L2_CTRL_FLAG_DISABLED))
    return std::nullopt;
  return query;
}

std::optional<int> readControl(V4l2Device& device, std::uint32_t id) {
  v4l2_control control = {};
  control.id = id;
  return device.ask(VIDIOC_G_CTRL, &control) < 0 ? std::nullopt : std::optional<int>(control.value);
}

void setControl(V4l2Device& device, std::uint32_t id, int value) {
  v4l2_control control = {};
  control.id = id;
  control.value = value;
  device.ask(VIDIOC_S_CTRL, &control);  // the value read back is the valid one
}

std::string withUnit(double value, const char* unit) {
  return formatted("%g", value) + (*unit ? std::string(" ") + unit : "");
}

void refuse(ControlState& state, const std::string& words) {
  state.lock = Lock::refused;
  state.words = words;
}

bool isManual(V4l2Device& device, const ControlPlan& plan) {
  if (!rangeOf(device, plan.automatic)) return true;
  if (readControl(device, plan.automatic) == plan.manual) return true;
  setControl(device, plan.automatic, plan.manual);
  return readControl(device, plan.automatic) == plan.manual;
}

/// Sets the wanted value and judges what the camera reads back.
void setAndRead(V4l2Device& device, const ControlPlan& plan, const v4l2_queryctrl& range,
                ControlState& state) {
  const double step = std::max(1, range.step) * plan.unit_per_step;
  const auto inSteps = [&](double value) { return int(std::lround(value / plan.unit_per_step)); };
  if (inSteps(*state.wanted) < range.minimum || inSteps(*state.wanted) > range.maximum)
    return refuse(state, withUnit(*state.wanted, plan.unit) + " is outside the camera's range, " +
                             formatted("%g", range.minimum * plan.unit_per_step) + " to " +
                             withUnit(range.maximum * plan.unit_per_step, plan.unit));
  if (readControl(device, plan.value) != inSteps(*state.wanted))
    setControl(device, plan.value, inSteps(*state.wanted));
  const auto read = readControl(device, plan.value);
  if (!read) return refuse(state, "the camera does not read its value back");
  state.actual = *read * plan.unit_per_step;
  if (std::abs(*state.actual - *state.wanted) > step)
    return refuse(state, withUnit(*state.wanted, plan.unit) + " was asked for, the camera keeps " +
                             withUnit(*state.actual, plan.unit));
  state.lock = Lock::locked;
  state.words.clear();
}

ControlState absentState(V4l2Device& device, const ControlPlan& plan, ControlState state) {
  const bool is_adjusting = rangeOf(device, plan.automatic) && !isManual(device, plan);
  if (is_adjusting)
    refuse(state, "the camera stays on automatic");
  else if (state.wanted)
    refuse(state, "the camera has no such control");
  else if (plan.matters_if_absent)
    refuse(state, "the camera has no such control; it may adjust itself unseen");
  return state;
}

ControlState lockControl(V4l2Device& device, const ControlPlan& plan, std::optional<double> wanted) {
  ControlState state{plan.name, plan.unit, wanted, std::nullopt, Lock::absent, ""};
  const auto range = rangeOf(device, plan.value);
  if (!range) return absentState(device, plan, state);
  if (const auto now = readControl(device, plan.value)) state.actual = *now * plan.unit_per_step;
  state.found = state.actual;
  if (!isManual(device, plan)) {
    refuse(state, "the camera stays on automatic");
    return state;
  }
  if (!state.wanted) state.wanted = state.actual;
  if (state.wanted)
    setAndRead(device, plan, *range, state);
  else
    refuse(state, "the camera does not read its value back");
  return state;
}

}  // namespace

std::vector<ControlState> lockControls(V4l2Device& device, const CameraSettings& settings) {
  // Without this, a dark room halves the rate: the driver takes longer exposures than the interval.
  if (rangeOf(device, V4L2_CID_EXPOSURE_AUTO_PRIORITY))
    setControl(device, V4L2_CID_EXPOSURE_AUTO_PRIORITY, 0);
  std::vector<ControlState> states;
  for (const ControlPlan& plan : kControls)
    states.push_back(lockControl(device, plan, settings.*plan.wanted));
  return states;
}

void freeControls(V4l2Device& device) {
  for (const ControlPlan& plan : kControls) {
    if (!rangeOf(device, plan.automatic)) continue;
    const bool is_exposure = plan.automatic == V4L2_CID_EXPOSURE_AUTO;
    setControl(device, plan.automatic, is_exposure ? int(V4L2_EXPOSURE_APERTURE_PRIORITY) : 1);
    if (is_exposure &&
        readControl(device, plan.automatic) == plan.manual)  // some have only the other automatic
      setControl(device, plan.automatic, V4L2_EXPOSURE_AUTO);
  }
}

void confirmControls(V4l2Device& device, std::vector<ControlState>& controls) {
  for (std::size_t i = 0; i < controls.size(); ++i) {
    if (controls[i].lock != Lock::locked) continue;
    const auto found = controls[i].found;  // before the first setting
    controls[i] = lockControl(device, kControls[i], controls[i].wanted);
    controls[i].found = found;
  }
}

}  // namespace facenav::capture
