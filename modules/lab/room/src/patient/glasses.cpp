#include "glasses.h"

#include <algorithm>
#include <cmath>

#include "optics/shapes.h"

namespace facenav::room {
namespace {

constexpr double kWide_mm = 25.0, kHigh_mm = 20.0, kRim_mm = 3.5, kOffEyes_mm = 14.0, kTemple_mm = 85.0;
constexpr int kSegments = 20;

/// Middle of landmarks `from` to `to` (both included).
Eigen::Vector3d middleOf(const VirtualPatient& patient, int from, int to) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int i = from; i <= to; ++i) sum += patient.landmarks68_mm[std::size_t(i)];
  return sum / double(to - from + 1);
}

/// Point on the rim around an eye, in a plane across the view (x, z).
Eigen::Vector3d onRim(const Eigen::Vector3d& eye_mm, int segment) {
  const double about = 2.0 * M_PI * segment / kSegments;
  return eye_mm + Eigen::Vector3d(kWide_mm * std::cos(about), 0.0, kHigh_mm * std::sin(about));
}

}  // namespace

surface::TriangleMesh glassesFrame(const VirtualPatient& patient) {
  if (patient.landmarks68_mm.size() < 68) return {};
  std::array<Eigen::Vector3d, 2> eyes{middleOf(patient, 36, 41), middleOf(patient, 42, 47)};
  const double plane_mm = std::max(eyes[0].y(), eyes[1].y()) + kOffEyes_mm;
  for (auto& eye : eyes) eye.y() = plane_mm;
  surface::TriangleMesh mesh;
  for (const auto& eye : eyes)
    for (int i = 0; i < kSegments; ++i) mesh = joined(mesh, bar(onRim(eye, i), onRim(eye, i + 1), kRim_mm));
  const bool is_first_left = eyes[0].x() < eyes[1].x();
  const auto &low = is_first_left ? eyes[0] : eyes[1], &high = is_first_left ? eyes[1] : eyes[0];
  const Eigen::Vector3d across(kWide_mm, 0.0, 0.0), back(8.0, -kTemple_mm, 0.0);
  mesh = joined(mesh, bar(low + across, high - across, kRim_mm));
  mesh = joined(mesh, bar(low - across, low - across + Eigen::Vector3d(-back.x(), back.y(), 0.0), kRim_mm));
  return joined(mesh, bar(high + across, high + across + back, kRim_mm));
}

}  // namespace facenav::room
