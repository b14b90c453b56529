#pragma once
// RigError: the calibration or the cameras are at fault. Searching for the face elsewhere would not help.
// Cold path (files, the start of a session).

#include <functional>
#include <string>

#include "facenav/cameras/stereo_frame.h"
#include "facenav/cameras/stereo_rig.h"
#include "facenav/core/error.h"
#include "facenav/health/pair_diagnosis.h"

namespace facenav::health {

class RigError : public Error {
 public:
  using Error::Error;
  /// `before`: text in front of the finding ("not aligned: ").
  explicit RigError(const RigVerdict& verdict, const std::string& before = {});
};

/// Runs `task`. If it throws an Error and the images of `frame` do not fit the rig, throws a RigError
/// instead, because the cameras are the cause.
void withRigError(const cameras::StereoRig& rig, const cameras::StereoFrame& frame,
                  const std::function<void()>& task);

}  // namespace facenav::health
