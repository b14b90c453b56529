#include "facenav/monitoring/pair_fault.h"

#include "facenav/core/error.h"

namespace facenav::monitoring {
namespace {

head_tracking::LossDetail detailOf(cameras::PairFault fault) {
  switch (fault) {
    case cameras::PairFault::out_of_step:
      return head_tracking::LossDetail::out_of_step;
    case cameras::PairFault::swapped:
      return head_tracking::LossDetail::swapped;
    case cameras::PairFault::other_rig:
      return head_tracking::LossDetail::other_rig;
    case cameras::PairFault::moved:
      return head_tracking::LossDetail::cameras_moved;
    case cameras::PairFault::unknown:
    case cameras::PairFault::none:
      break;
  }
  return head_tracking::LossDetail::unknown;
}

}  // namespace

std::optional<RigFault> rigFault(const cameras::PairDiagnosis& diagnosis) {
  if (!diagnosis.isFault()) return std::nullopt;
  return RigFault{detailOf(diagnosis.fault), diagnosis.words() + ": " + diagnosis.advice()};
}

PairError::PairError(const cameras::PairDiagnosis& diagnosis, const std::string& before)
    : Error(before + diagnosis.words(), {}, diagnosis.advice()) {}

void withPairFault(const cameras::StereoRig& rig, const cameras::StereoFrame& frame,
                   const std::function<void()>& task) {
  try {
    task();
  } catch (const PairError&) {
    throw;
  } catch (const Cancelled&) {
    throw;
  } catch (const Error&) {
    const auto diagnosis = cameras::diagnosePair(rig, frame);
    if (diagnosis.isFault()) throw PairError(diagnosis);
    throw;
  }
}

}  // namespace facenav::monitoring
