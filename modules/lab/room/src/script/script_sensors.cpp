#include <cmath>

#include "facenav/geometry/normal_equations.h"
#include "facenav/geometry/rotation.h"
#include "script_setting.h"

namespace facenav::room {

MomentOf fastCoilScript(const Setting& setting) {
  // The marker faces the cameras beside the face and swings at up to 300 mm/s.
  const Eigen::Vector3d middle_mm(0.22 * setting.options.head_distance_mm,
                                  -0.10 * setting.options.head_distance_mm,
                                  0.85 * setting.options.head_distance_mm);
  return [setting, middle_mm](double frame) {
    const double t_s = setting.time_s(frame), start = ease(t_s / 0.5);
    const Eigen::Vector3d at_mm =
        middle_mm + start * Eigen::Vector3d(32.0 * std::sin(2.0 * M_PI * 1.2 * t_s),
                                            26.0 * std::sin(2.0 * M_PI * 0.9 * t_s),
                                            30.0 * std::sin(2.0 * M_PI * 0.7 * t_s));
    Moment moment;
    moment.cast = setting.headMovedBy(sway(t_s, setting.options.motion));
    const Eigen::Quaterniond facing = rotationBetween(Eigen::Vector3d::UnitZ(), at_mm);
    Eigen::Isometry3d room_T_marker = Eigen::Isometry3d::Identity();
    room_T_marker.linear() =
        facing.toRotationMatrix() * expRotation(kRadPerDeg * Eigen::Vector3d(12.0, -18.0, 10.0));
    room_T_marker.translation() = at_mm;
    moment.cast.room_T_coil =
        RigidTransform<Room, Marker>::fromIsometry(room_T_marker) * setting.marker_T_coil;
    moment.label = "coil swings";
    return moment;
  };
}

MomentOf glassesScript(const Setting& setting) {
  constexpr double kPutOn = 0.3;  // part of the recording
  return [setting, treated = treatmentScript(setting)](double frame) {
    Moment moment = treated(frame);
    moment.cast.has_glasses = setting.part(frame) >= kPutOn;
    moment.label = moment.cast.has_glasses ? "glasses put on" : "no glasses";
    return moment;
  };
}

}  // namespace facenav::room
