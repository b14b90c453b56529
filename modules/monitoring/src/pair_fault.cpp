#include "facenav/monitoring/pair_fault.h"

#include "facenav/core/error.h"

namespace facenav::monitoring {
namespace {

tracking::LossDetail detailOf(stereo::PairFault fault) {
  switch (fault) {
    case stereo::PairFault::out_of_step:
      return tracking::LossDetail::out_of_step;
    case stereo::PairFault::swapped:
      return tracking::LossDetail::swapped;
    case stereo::PairFault::other_rig:
      return tracking::LossDetail::other_rig;
    case stereo::PairFault::moved:
      return tracking::LossDetail::cameras_moved;
    case stereo::PairFault::unknown:
    case stereo::PairFault::none:
      break;
  }
  return tracking::LossDetail::unknown;
}

}  // namespace

std::optional<RigFault> rigFault(const stereo::PairDiagnosis& diagnosis) {
  if (!diagnosis.isFault()) return std::nullopt;
  return RigFault{detailOf(diagnosis.fault), diagnosis.words() + ": " + diagnosis.advice()};
}

PairError::PairError(const stereo::PairDiagnosis& diagnosis, const std::string& before)
    : Error(before + diagnosis.words(), {}, diagnosis.advice()) {}

void withPairFault(const stereo::StereoRig& rig, const stereo::StereoFrame& frame,
                   const std::function<void()>& task) {
  try {
    task();
  } catch (const PairError&) {
    throw;
  } catch (const Cancelled&) {
    throw;
  } catch (const Error&) {
    const auto diagnosis = stereo::diagnosePair(rig, frame);
    if (diagnosis.isFault()) throw PairError(diagnosis);
    throw;
  }
}

}  // namespace facenav::monitoring
