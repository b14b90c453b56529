#pragma once
// Matchers that print both values: EigenNear(expected, tolerance), PoseNear(expected, degrees, mm).

#include <gmock/gmock.h>

#include <Eigen/Core>
#include <sstream>

#include "facenav/geometry/pose_error.h"

namespace facenav::testing {

MATCHER_P2(EigenNear, expected, tolerance, "") {
  std::ostringstream text;
  text << "expected [" << expected.transpose() << "], got [" << arg.transpose() << "]";
  *result_listener << text.str();
  return (arg - expected).cwiseAbs().maxCoeff() <= tolerance;
}

MATCHER_P3(PoseNear, expected, tolerance_deg, tolerance_mm, "") {
  const auto error = poseError(arg, expected);
  const double rotation_deg = error.rotation_rad * 180.0 / M_PI;
  *result_listener << "rotation off by " << rotation_deg << " deg, translation by " << error.translation_mm
                   << " mm";
  return rotation_deg <= tolerance_deg && error.translation_mm <= tolerance_mm;
}

}  // namespace facenav::testing
