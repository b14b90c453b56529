#pragma once
// Where a pair of pictures gives no face, no cloud or no start of tracking: is it the cameras? The cold path
// from stereo::PairDiagnosis to the words of an Error.

#include <functional>
#include <optional>
#include <string>

#include "facenav/core/error.h"
#include "facenav/stereo/pair_diagnosis.h"
#include "facenav/tracking/loss_detail.h"

namespace facenav::monitoring {

/// Why no pose of these cameras can be trusted.
struct RigFault {
  tracking::LossDetail detail = tracking::LossDetail::unknown;
  std::string words;  // one line, with the advice
};

/// Nothing where the diagnosis names no fault.
std::optional<RigFault> rigFault(const stereo::PairDiagnosis& diagnosis);

/// The calibration or the cameras are at fault: looking elsewhere for the face would not help.
class PairError : public Error {
 public:
  explicit PairError(const stereo::PairDiagnosis& diagnosis, const std::string& before = {});
};

/// Runs `task`. Where it throws an Error and the pictures of `frame` do not fit the rig, throws a PairError
/// in its place: what failed is the consequence.
void withPairFault(const stereo::StereoRig& rig, const stereo::StereoFrame& frame,
                   const std::function<void()>& task);

}  // namespace facenav::monitoring
