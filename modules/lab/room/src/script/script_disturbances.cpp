#include <algorithm>
#include <cmath>

#include "facenav/geometry/normal_equations.h"
#include "facenav/geometry/rotation.h"
#include "script_setting.h"

namespace facenav::room {
namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;

Eigen::Isometry3d placed(const Eigen::Matrix3d& rotation, const Eigen::Vector3d& at_mm) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = rotation;
  pose.translation() = at_mm;
  return pose;
}

/// A coil with its marker at `marker_mm` (Room). The marker faces the cameras, then is turned by a rotation
/// vector.
RigidTransform<Room, Coil> coilWithMarkerAt(const Setting& setting, const Eigen::Vector3d& marker_mm,
                                            const Eigen::Vector3d& turn_deg) {
  // Facing the cameras: z (into the plate) is along the line of sight.
  const Eigen::Quaterniond facing = rotationBetween(Eigen::Vector3d::UnitZ(), marker_mm);
  const auto room_T_marker = RigidTransform<Room, Marker>::fromIsometry(
      placed(facing.toRotationMatrix() * expRotation(turn_deg * kRadPerDeg), marker_mm));
  return room_T_marker * setting.marker_T_coil;
}

/// The parts of "lost", in order: end (0..1), event.
const Parts kLostParts({{0.14, "face in view"},
                        {0.34, "head turns away and back"},
                        {0.44, "face in view"},
                        {0.64, "head leaves the view and returns"},
                        {0.70, "face in view"},
                        {0.75, "both cameras black"},
                        {0.79, "face in view"},
                        {0.83, "left camera black"},
                        {0.87, "face in view"},
                        {0.91, "cameras frozen"},
                        {0.94, "face in view"},
                        {0.97, "left and right swapped"},
                        {1.01, "face in view"}});

CameraFault faultOf(const std::string& label) {
  if (label == "both cameras black") return CameraFault::black_both;
  if (label == "left camera black") return CameraFault::black_left;
  if (label == "cameras frozen") return CameraFault::frozen;
  if (label == "left and right swapped") return CameraFault::swapped;
  return CameraFault::none;
}

}  // namespace

MomentOf occlusionScript(const Setting& setting) {
  return [setting](double frame) {
    const double part = setting.part(frame);
    Moment moment;
    moment.cast = setting.headMovedBy(sway(setting.time_s(frame), setting.options.motion));
    const Eigen::Vector3d face_mm = setting.face_mm();
    if (part > 0.15 && part < 0.55) {
      // A hand comes from the image's right, hides cheek and side of the mouth, and leaves.
      const double in = hill((part - 0.15) / 0.4);
      const Eigen::Vector3d at_mm = face_mm + Eigen::Vector3d(185.0 - 130.0 * in, 35.0, -75.0);
      moment.cast.room_T_hand = placed(expRotation(Eigen::Vector3d(0.15, 0.0, -0.5)), at_mm);
      moment.label = "hand before the face";
    } else if (part > 0.6) {
      // The coil is carried across brow and one eye.
      const double in = hill((part - 0.6) / 0.4);
      const Eigen::Vector3d at_mm = face_mm + Eigen::Vector3d(90.0 - 60.0 * in, -190.0 + 60.0 * in, -110.0);
      moment.cast.room_T_coil = coilWithMarkerAt(setting, at_mm, {10.0, -15.0, 10.0});
      moment.label = "coil carried past the face";
    } else {
      moment.label = "free view";
    }
    return moment;
  };
}

MomentOf talkingScript(const Setting& setting) {
  return [setting](double frame) {
    const double t = setting.time_s(frame), on = ease(t / 0.3);
    Moment moment;
    moment.cast = setting.headMovedBy(sway(t, 0.6 * setting.options.motion));
    const double speech =
        0.5 + 0.35 * std::sin(2 * M_PI * 3.1 * t) + 0.3 * std::sin(2 * M_PI * 1.3 * t + 1.0);
    moment.cast.jaw_mm = on * 9.0 * std::clamp(speech, 0.0, 1.0);
    const double since_blink_s = std::fmod(t + 0.6, 1.1);
    moment.cast.lids = since_blink_s < 0.2 ? hill(since_blink_s / 0.2) : 0.0;
    moment.label = moment.cast.lids > 0.5 ? "talking, blink" : "talking";
    return moment;
  };
}

MomentOf lightingScript(const Setting& setting) {
  return [setting](double frame) {
    const double t = setting.time_s(frame), part = setting.part(frame), on = ease(6.0 * part);
    Moment moment;
    moment.cast = setting.headMovedBy(sway(t, setting.options.motion));
    moment.cast.lamp_scale = 1.0 + 0.4 * on * std::sin(2 * M_PI * 2.0 * part);
    moment.cast.ambient_scale = 1.0 + 0.25 * on * std::sin(2 * M_PI * 1.3 * part + 0.5);
    moment.cast.lamp_shift_mm =
        on * Eigen::Vector3d(700.0 * std::sin(2 * M_PI * part), 250.0 * std::sin(4 * M_PI * part), 0.0);
    moment.label = "lamps change";
    return moment;
  };
}

MomentOf lostScript(const Setting& setting) {
  return [setting](double frame) {
    const double part = setting.part(frame);
    const auto [label, inside] = kLostParts.at(part);
    Moment moment;
    moment.label = label;
    moment.fault = faultOf(moment.label);
    Vector6 by = sway(setting.time_s(frame), setting.options.motion);
    if (moment.label == "head turns away and back") by[1] += 160.0 * hill(inside);
    if (moment.label == "head leaves the view and returns") by[3] += 700.0 * hill(inside);
    moment.cast = setting.headMovedBy(by);
    return moment;
  };
}

MomentOf coilSweepScript(const Setting& setting) {
  return [setting](double frame) {
    const double part = setting.part(frame);
    Moment moment;
    Vector6 by = sway(setting.time_s(frame), setting.options.motion);
    by.tail<3>() += Eigen::Vector3d(-80.0, 20.0, 120.0);  // moved aside, so that the marker can pass it
    moment.cast = setting.headMovedBy(by);
    const double depth_mm = 400.0 + 500.0 * part, tilt_deg = 60.0 * std::abs(std::sin(2 * M_PI * 2.5 * part));
    const double about = 2 * M_PI * 0.7 * part + 0.4;
    const Eigen::Vector3d at_mm(0.22 * depth_mm,
                                0.08 * depth_mm * std::sin(2 * M_PI * part) - 0.04 * depth_mm, depth_mm);
    moment.cast.room_T_coil =
        coilWithMarkerAt(setting, at_mm, tilt_deg * Eigen::Vector3d(std::cos(about), std::sin(about), 0.0));
    char label[64];
    std::snprintf(label, sizeof label, "marker at %.0f mm, tilt %.0f deg", at_mm.norm(), tilt_deg);
    moment.label = label;
    return moment;
  };
}

}  // namespace facenav::room
