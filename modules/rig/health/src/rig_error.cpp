#include "facenav/health/rig_error.h"

namespace facenav::health {

RigError::RigError(const RigVerdict& verdict, const std::string& before)
    : Error(before + verdict.finding, {}, verdict.advice) {}

void withRigError(const cameras::StereoRig& rig, const cameras::StereoFrame& frame,
                  const std::function<void()>& task) {
  try {
    task();
  } catch (const RigError&) {
    throw;
  } catch (const Cancelled&) {
    throw;
  } catch (const Error&) {
    const auto diagnosis = diagnosePair(rig, frame);
    if (diagnosis.isFault()) throw RigError(diagnosis.verdict());
    throw;
  }
}

}  // namespace facenav::health
