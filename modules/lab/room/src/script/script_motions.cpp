#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "facenav/geometry/rotation.h"
#include "script_setting.h"

namespace facenav::room {
namespace {

/// Pose of the coil relative to its target: at 0, 150 mm away and turned; at 1, on the target.
RigidTransform<frames::Target, Coil> onApproach(double progress) {
  const double left = 1.0 - ease(progress);
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = expRotation(left * Eigen::Vector3d(14.0, -10.0, 18.0) * kRadPerDeg);
  pose.translation() = left * Eigen::Vector3d(-40.0, -50.0, -135.0);
  return RigidTransform<frames::Target, Coil>::fromIsometry(pose);
}

/// Free motion: each of the six degrees of freedom reaches its full size about once in four seconds; the seed
/// sets direction and speed.
struct Swing {
  double peak, rate_hz;
};
std::array<Swing, 6> swings(std::uint64_t seed) {
  // Pitch, yaw, roll (deg); x, y, z (mm). The combined shifts stay below 100 mm/s.
  std::array<Swing, 6> all{
      {{15.0, 0.24}, {30.0, 0.25}, {15.0, 0.21}, {60.0, 0.20}, {25.0, 0.20}, {40.0, 0.15}}};
  std::mt19937_64 random(seed * 101 + 3);
  for (auto& swing : all) {
    if (random() % 2) swing.peak = -swing.peak;
    swing.rate_hz *= 0.9 + 0.2 * double(random() >> 11) * 0x1p-53;
  }
  return all;
}

}  // namespace

double hill(double x) { return ease(2.0 * std::min(x, 1.0 - x)); }

Eigen::Matrix<double, 6, 1> sway(double time_s, double scale) {
  Eigen::Matrix<double, 6, 1> by;
  by << 1.2 * std::sin(1.9 * time_s), 2.0 * std::sin(1.3 * time_s), 0.8 * std::sin(2.3 * time_s),
      4.0 * std::sin(1.1 * time_s), 3.0 * std::sin(1.7 * time_s), 5.0 * std::sin(0.9 * time_s);
  return scale * by;
}

double ease(double x) {
  x = std::clamp(x, 0.0, 1.0);
  return x * x * x * (10.0 + x * (6.0 * x - 15.0));
}

RigidTransform<Room, Mri> Setting::moved(const Eigen::Matrix<double, 6, 1>& by) const {
  const Eigen::Vector3d pivot_mm = (seat * pivot).mm;
  Eigen::Isometry3d turn = Eigen::Isometry3d::Identity();
  turn.linear() = expRotation(by.head<3>() * kRadPerDeg);
  turn.translation() = pivot_mm - turn.linear() * pivot_mm + by.tail<3>();
  return RigidTransform<Room, Mri>::fromIsometry(turn * seat.isometry());
}

Cast Setting::headMovedBy(const Eigen::Matrix<double, 6, 1>& by) const {
  Cast cast;
  cast.room_T_mri = moved(by);
  return cast;
}

HeadMotion Setting::motion(MotionSize size) const {
  size.rotation_deg *= options.motion;
  size.shift_mm *= options.motion;
  return HeadMotion(size, options.seed);
}

MomentOf stillScript(const Setting& setting) {
  return [setting](double) {
    Moment moment;
    moment.cast.room_T_mri = setting.seat;
    moment.label = "still";
    return moment;
  };
}

MomentOf protractorScript(const Setting& setting) {
  return [setting](double frame) {
    const int number = int(frame), axis = std::min(2, number / 11), step = number % 11 - 5;
    Eigen::Matrix<double, 6, 1> by = Eigen::Matrix<double, 6, 1>::Zero();
    by[axis] = 2.5 * step;
    Moment moment;
    moment.cast = setting.headMovedBy(by);
    char label[64];
    std::snprintf(label, sizeof label, "turned by %.1f deg about %c", by[axis], "xyz"[axis]);
    moment.label = label;
    return moment;
  };
}

MomentOf freeMotionScript(const Setting& setting) {
  return [setting, all = swings(setting.options.seed)](double frame) {
    // Time starts smoothly, so that no speed exceeds that of the swing.
    constexpr double kStart_s = 0.3;
    const double t_s = setting.time_s(frame), swung_s = t_s - kStart_s * (1.0 - std::exp(-t_s / kStart_s));
    Eigen::Matrix<double, 6, 1> by;
    for (int i = 0; i < 6; ++i)
      by[i] = setting.options.motion * all[i].peak * std::sin(2.0 * M_PI * all[i].rate_hz * swung_s);
    Moment moment;
    moment.cast = setting.headMovedBy(by);
    moment.label = "moving";
    return moment;
  };
}

MomentOf turningScript(const Setting& setting) {
  // Turns from the seat to one side, back, and to the other side, the chin a little down and up meanwhile.
  constexpr double kYaw_deg = 15.0, kPitch_deg = 4.0, kSlide_mm = 8.0;
  return [setting](double frame) {
    const double part = 2.0 * M_PI * setting.part(frame);
    Eigen::Matrix<double, 6, 1> by = sway(setting.time_s(frame), 0.2);
    by[0] += setting.options.motion * kPitch_deg * std::sin(2.0 * part);
    by[1] += setting.options.motion * kYaw_deg * std::sin(part);
    by[3] += setting.options.motion * kSlide_mm * std::sin(part);
    Moment moment;
    moment.cast = setting.headMovedBy(by);
    moment.label = "turning";
    return moment;
  };
}

MomentOf treatmentScript(Setting setting) {
  // The head has moved slightly since the capture pair.
  Eigen::Matrix<double, 6, 1> since;
  since << 1.0, -1.5, 0.7, 3.0, -2.0, 4.0;
  setting.seat = setting.moved(setting.options.motion * since);
  const HeadMotion motion = setting.motion({});
  // The coil stays on its target for the last second (half of a shorter recording).
  const double hold = std::min(0.5, setting.options.frames_per_s / std::max(1, setting.frames));
  return [setting, motion, hold](double frame) {
    Moment moment;
    moment.cast = setting.headMovedBy(motion.at(setting.time_s(frame)));
    const double progress = setting.part(frame) / (1.0 - hold);
    moment.cast.room_T_coil = moment.cast.room_T_mri * setting.target * onApproach(progress);
    if (setting.second_target)
      moment.cast.room_T_second = moment.cast.room_T_mri * *setting.second_target * onApproach(progress);
    moment.label = progress < 1.0 ? "approach" : "on target";
    return moment;
  };
}

}  // namespace facenav::room
