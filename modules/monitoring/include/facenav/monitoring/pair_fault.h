#pragma once
// Where a pair of pictures gives no face, no cloud or no start of tracking: is it the cameras? The cold path
// from cameras::PairDiagnosis to the words of an Error.

#include <functional>
#include <optional>
#include <string>

#include "facenav/cameras/pair_diagnosis.h"
#include "facenav/core/error.h"
#include "facenav/head_tracking/loss_detail.h"

namespace facenav::monitoring {

/// Why no pose of these cameras can be trusted.
struct RigFault {
  head_tracking::LossDetail detail = head_tracking::LossDetail::unknown;
  std::string words;  // one line, with the advice
};

/// Nothing where the diagnosis names no fault.
std::optional<RigFault> rigFault(const cameras::PairDiagnosis& diagnosis);

/// The calibration or the cameras are at fault: looking elsewhere for the face would not help.
class PairError : public Error {
 public:
  explicit PairError(const cameras::PairDiagnosis& diagnosis, const std::string& before = {});
};

/// Runs `task`. Where it throws an Error and the pictures of `frame` do not fit the rig, throws a PairError
/// in its place: what failed is the consequence.
void withPairFault(const cameras::StereoRig& rig, const cameras::StereoFrame& frame,
                   const std::function<void()>& task);

}  // namespace facenav::monitoring
