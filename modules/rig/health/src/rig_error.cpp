#include "facenav/health/rig_error.h"

namespace facenav::health {

RigError::RigError(const PairDiagnosis& diagnosis, const std::string& before)
    : Error(before + diagnosis.verdict().finding, {}, diagnosis.verdict().advice) {}

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
    if (diagnosis.isFault()) throw RigError(diagnosis);
    throw;
  }
}

}  // namespace facenav::health
