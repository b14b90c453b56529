#include "genicam_controls.h"

#include <cmath>
#include <cstring>

#include "facenav/core/number_text.h"

namespace facenav::capture {
namespace {

using GenicamLock = ControlState::Lock;

struct GenicamControl {
  const char *name, *unit;
  double per_unit;  // camera's units per unit used here: us per ms
  gboolean (*is_there)(ArvCamera*, GError**);
  gboolean (*has_automatic)(ArvCamera*, GError**);
  void (*set_automatic)(ArvCamera*, ArvAuto, GError**);
  ArvAuto (*get_automatic)(ArvCamera*, GError**);
  void (*set)(ArvCamera*, double, GError**);
  double (*get)(ArvCamera*, GError**);
  void (*range)(ArvCamera*, double*, double*, GError**);
};

const GenicamControl kExposure{"exposure",
                               "ms",
                               1000.0,
                               arv_camera_is_exposure_time_available,
                               arv_camera_is_exposure_auto_available,
                               arv_camera_set_exposure_time_auto,
                               arv_camera_get_exposure_time_auto,
                               arv_camera_set_exposure_time,
                               arv_camera_get_exposure_time,
                               arv_camera_get_exposure_time_bounds};
const GenicamControl kGain{"gain",
                           "",
                           1.0,
                           arv_camera_is_gain_available,
                           arv_camera_is_gain_auto_available,
                           arv_camera_set_gain_auto,
                           arv_camera_get_gain_auto,
                           arv_camera_set_gain,
                           arv_camera_get_gain,
                           arv_camera_get_gain_bounds};

constexpr double kReadBackWithin = 0.01;  // relative: cameras round to their own steps

std::string genicamValue(double value, const GenicamControl& control) {
  return formatted("%g", value) + (*control.unit ? std::string(" ") + control.unit : "");
}

ControlState refused(ControlState state, const std::string& words) {
  state.lock = GenicamLock::refused;
  state.words = words;
  return state;
}

bool isSwitchedOff(ArvCamera* camera, const GenicamControl& control) {
  GenicamCall call;
  if (!control.has_automatic(camera, call) || !call.isOk()) return true;
  control.set_automatic(camera, ARV_AUTO_OFF, call);
  return control.get_automatic(camera, call) == ARV_AUTO_OFF && call.isOk();
}

ControlState lockOne(ArvCamera* camera, const GenicamControl& control, std::optional<double> wanted) {
  ControlState state{control.name, control.unit, wanted, std::nullopt, GenicamLock::absent, ""};
  GenicamCall call;
  if (!control.is_there(camera, call) || !call.isOk())
    return wanted ? refused(state, "the camera has no such control") : state;
  state.found = control.get(camera, call) / control.per_unit;
  if (!isSwitchedOff(camera, control)) return refused(state, "the camera stays on automatic");
  if (!wanted) state.wanted = control.get(camera, call) / control.per_unit;
  double least = 0, most = 0;
  control.range(camera, &least, &most, call);
  least /= control.per_unit;
  most /= control.per_unit;
  if (call.isOk() && (*state.wanted < least || *state.wanted > most))
    return refused(state, genicamValue(*state.wanted, control) + " is outside the camera's range, " +
                              formatted("%g", least) + " to " + genicamValue(most, control));
  if (wanted) control.set(camera, *wanted * control.per_unit, call);
  state.actual = control.get(camera, call) / control.per_unit;
  if (!call.isOk()) return refused(state, "the camera does not read its value back (" + call.words() + ")");
  if (std::abs(*state.actual - *state.wanted) > kReadBackWithin * std::max(1.0, std::abs(*state.wanted)))
    return refused(state, genicamValue(*state.wanted, control) + " was asked for, the camera keeps " +
                              genicamValue(*state.actual, control));
  state.lock = GenicamLock::locked;
  return state;
}

/// Locks the white balance; absent in cameras of grey pictures.
ControlState lockWhiteBalance(ArvCamera* camera, std::optional<double> wanted) {
  ControlState state{"white balance", "K", wanted, std::nullopt, GenicamLock::absent, ""};
  if (wanted) return refused(state, "GenICam cameras have no colour temperature");
  GenicamCall call;
  constexpr const char* kAutomatic = "BalanceWhiteAuto";
  if (!arv_camera_is_feature_available(camera, kAutomatic, call) || !call.isOk()) return state;
  arv_camera_set_string(camera, kAutomatic, "Off", call);
  const char* now = arv_camera_get_string(camera, kAutomatic, call);
  if (!call.isOk() || !now || std::strcmp(now, "Off") != 0)
    return refused(state, "the camera stays on automatic");
  state.lock = GenicamLock::locked;
  return state;
}

ControlState fixedFocus(std::optional<double> wanted) {
  const ControlState state{"focus", "", wanted, std::nullopt, GenicamLock::absent, ""};
  return wanted ? refused(state, "the lens is focused by hand") : state;
}

/// Name of the trigger source: "Software", or the first input line.
std::string triggerSource(ArvCamera* camera, Trigger trigger) {
  GenicamCall call;
  guint count = 0;
  const std::unique_ptr<const char*, decltype(&g_free)> names(
      arv_camera_dup_available_trigger_sources(camera, &count, call), g_free);
  for (guint i = 0; names && i < count; ++i) {
    const std::string name = names.get()[i];
    if (trigger == Trigger::software ? name == "Software" : name.rfind("Line", 0) == 0) return name;
  }
  return "";
}

}  // namespace

std::vector<ControlState> lockControls(ArvCamera* camera, const CameraSettings& settings) {
  return {lockOne(camera, kExposure, settings.exposure_ms), lockOne(camera, kGain, settings.gain),
          fixedFocus(settings.focus), lockWhiteBalance(camera, settings.white_balance_k)};
}

void freeControls(ArvCamera* camera) {
  GenicamCall call;
  for (const GenicamControl* control : {&kExposure, &kGain})
    if (control->has_automatic(camera, call)) control->set_automatic(camera, ARV_AUTO_CONTINUOUS, call);
}

void setTrigger(ArvCamera* camera, Trigger trigger, const std::string& where) {
  GenicamCall call;
  if (trigger == Trigger::free_run) {
    arv_camera_clear_triggers(camera, call);  // a camera without triggers runs free anyway
    return;
  }
  const std::string source = triggerSource(camera, trigger);
  if (!source.empty()) arv_camera_set_trigger(camera, source.c_str(), call);
  if (source.empty() || !call.isOk())
    throw CameraError(CameraFault::refused,
                      trigger == Trigger::software ? "the camera has no software trigger"
                                                   : "the camera has no trigger input",
                      where, "let the cameras run free, or use cameras with a trigger");
}

}  // namespace facenav::capture
