#pragma once
// When a pair of images gives no face, no cloud or no start of tracking: are the cameras the cause? Turns a
// cameras::PairDiagnosis into the words of an Error. Cold path.

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
  std::string words;  // one line, with advice
};

/// Nothing if the diagnosis names no fault.
std::optional<RigFault> rigFault(const cameras::PairDiagnosis& diagnosis);

/// The calibration or the cameras are at fault: searching for the face elsewhere would not help.
class PairError : public Error {
 public:
  explicit PairError(const cameras::PairDiagnosis& diagnosis, const std::string& before = {});
};

/// Runs `task`. If it throws an Error and the images of `frame` do not fit the rig, throws a PairError
/// instead, because the cameras are the cause.
void withPairFault(const cameras::StereoRig& rig, const cameras::StereoFrame& frame,
                   const std::function<void()>& task);

}  // namespace facenav::monitoring
