#include "facenav/guidance/instruction.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "facenav/geometry/rotation.h"

namespace facenav::guidance {
namespace {

struct Need {
  Action action;
  double excess;  // value / tolerance
};

std::vector<Need> needs(const GuidanceValues& values, const Tolerance& tolerance) {
  return {
      {Action::move, values.lateral_mm / tolerance.lateral_mm},
      {values.depth_mm > 0 ? Action::lift : Action::press, std::abs(values.depth_mm) / tolerance.depth_mm},
      {Action::tilt, values.tilt_rad / tolerance.tilt_rad},
      {Action::turn, std::abs(values.twist_rad) / tolerance.twist_rad}};
}

std::string rounded(double value, const std::string& unit) {
  return std::to_string(std::max(1L, std::lround(std::abs(value)))) + unit;
}
std::string degrees(double angle_rad) { return rounded(angle_rad * kDegPerRad, "°"); }

/// Names the Mri axis closest to `direction`, in the patient's terms. Left and right win a near tie (over M1
/// the tangent plane points left and down equally).
std::string patientDirection(const Eigen::Vector3d& direction) {
  const Eigen::Vector3d weight(1.3 * std::abs(direction.x()), std::abs(direction.y()),
                               std::abs(direction.z()));
  Eigen::Index axis = 0;
  weight.maxCoeff(&axis);
  const bool is_positive = direction[axis] > 0;
  if (axis == 0) return is_positive ? "to the patient's right" : "to the patient's left";
  if (axis == 1) return is_positive ? "towards the face" : "towards the back of the head";
  return is_positive ? "up, towards the top of the head" : "down, towards the neck";
}

/// Describes the larger component of the lateral offset, along two axes of the tangent plane: front-back
/// (up-down over forehead and occiput) and perpendicular to it.
std::string moveWords(const Target& target, const GuidanceValues& values) {
  const Eigen::Matrix3d mri_R_target = target.mri_T_target.rotation();
  const Eigen::Vector3d z = mri_R_target.col(2);
  const Eigen::Vector3d way_mm = -mri_R_target.leftCols<2>() * values.lateral_in_target_mm;
  const Eigen::Vector3d forward = std::abs(z.y()) > 0.9 ? Eigen::Vector3d::UnitZ() : Eigen::Vector3d::UnitY();
  const Eigen::Vector3d a = (forward - forward.dot(z) * z).normalized(), b = z.cross(a);
  const Eigen::Vector3d main = std::abs(way_mm.dot(a)) > std::abs(way_mm.dot(b)) ? a : b;
  const double way_along_mm = way_mm.dot(main);
  return "move " + rounded(way_along_mm, "") + " mm " + patientDirection(way_along_mm * main);
}

std::string tiltWords(const GuidanceValues& values) {
  const Eigen::Vector2d& tilt_rad = values.tilt_in_coil_rad;
  if (std::abs(tilt_rad.x()) >= std::abs(tilt_rad.y()))  // about +x: the -y side (the handle's) rises
    return std::string("tilt the handle side ") + (tilt_rad.x() > 0 ? "up " : "down ") +
           degrees(tilt_rad.x());
  return std::string("tilt the left wing ") + (tilt_rad.y() > 0 ? "up " : "down ") + degrees(tilt_rad.y());
}

std::string words(Action action, const Target& target, const GuidanceValues& values) {
  switch (action) {
    case Action::none:
      return "";
    case Action::hold:
      return "hold";
    case Action::move:
      return moveWords(target, values);
    case Action::lift:
      return "lift the coil " + rounded(values.depth_mm, " mm");
    case Action::press:
      return "press " + rounded(values.depth_mm, " mm") + " closer";
    case Action::tilt:
      return tiltWords(values);
    case Action::turn:
      return std::string("turn ") + (values.twist_rad > 0 ? "counterclockwise" : "clockwise") +
             " seen from above the coil " + degrees(values.twist_rad);
  }
  FACENAV_EXPECT(false, "unknown action");
}

}  // namespace

Instruction instruct(const Target& target, const GuidanceValues& values, const Tolerance& tolerance,
                     Action previous, const Hysteresis& hysteresis) {
  const std::vector<Need> all = needs(values, tolerance);
  const Need worst = *std::max_element(all.begin(), all.end(),
                                       [](const Need& a, const Need& b) { return a.excess < b.excess; });
  const double limit = previous == Action::hold ? hysteresis.release : 1.0;
  Action action = worst.excess <= limit ? Action::hold : worst.action;
  for (const Need& need : all)
    if (action != Action::hold && need.action == previous && need.excess > 1.0 &&
        worst.excess < hysteresis.change * need.excess)
      action = previous;
  return {action, words(action, target, values)};
}

std::string lossInWords(LostReason reason, bool is_head) {
  switch (reason) {
    case LostReason::no_face:
      return "lost: the face is not seen";
    case LostReason::few_features:
      return "lost: too little of the face is seen";
    case LostReason::no_marker:
      return "lost: the coil's marker is not seen";
    case LostReason::high_residual:
      return is_head ? "lost: the face does not fit the cameras' views"
                     : "lost: the marker does not fit the cameras' views";
    case LostReason::camera:
      return "lost: no picture from the cameras";
    case LostReason::stale:
      return "lost: the picture is too old";
  }
  FACENAV_EXPECT(false, "unknown reason of loss");
}

}  // namespace facenav::guidance
