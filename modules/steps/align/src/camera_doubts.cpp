#include "camera_doubts.h"

#include "facenav/health/pair_diagnosis.h"
#include "facenav/health/rig_error.h"
#include "facenav/measured_face/projected_dots.h"

namespace facenav::steps {

std::optional<Error> errorOf(const std::function<void()>& task) {
  try {
    task();
    return std::nullopt;
  } catch (const health::RigError&) {
    throw;
  } catch (const Cancelled&) {
    throw;
  } catch (const Error& error) {
    return error;
  }
}

[[noreturn]] void refuseAlignment(const cameras::StereoRig& rig, const capture::CapturePair& capture,
                                  measured_face::AlignedFrom from, const Error& error, bool is_measured,
                                  const std::string& matcher) {
  const auto diagnosis = health::diagnosePair(rig, capture.plain);
  if (diagnosis.isFault()) throw health::RigError(diagnosis, "not aligned: ");
  if (from != measured_face::AlignedFrom::dots || measured_face::showsDots(capture)) {
    if (is_measured) throw error;
    throw NotMeasured(error.what());
  }
  std::string reason = error.what();
  const std::string prefix = "not aligned: ";
  if (reason.rfind(prefix, 0) == 0) reason.erase(0, prefix.size());
  const bool is_default = matcher == stereo::kDefaultMatcher;
  throw Error(prefix + "the capture's picture for the dots shows none, or too few (switch the projector on" +
              (is_default ? "" : ": the matcher '" + matcher + "' needs them") +
              "); without them: " + reason);
}

}  // namespace facenav::steps
