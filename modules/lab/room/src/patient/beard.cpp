#include <algorithm>
#include <cmath>

#include "facenav/room/person_shape.h"
#include "optics/noise_field.h"
#include "skin_mesh.h"
#include "smooth_step.h"

namespace facenav::room {
namespace {

/// Share 0..1 of a beard at a point of the skin: below a line from the ears to the nose's base, not on lips.
double beardAt(const std::vector<Eigen::Vector3d>& l, const Eigen::Vector3d& p_mm) {
  const Eigen::Vector3d mouth_mm = 0.5 * (l[51] + l[57]), from_mm = p_mm - mouth_mm;
  const double nose_mm = l[33].z() - mouth_mm.z(), half_width_mm = 0.5 * std::abs(l[48].x() - l[54].x());
  const double aside = std::abs(from_mm.x());
  // The upper edge: below the nose in the middle, down to the mouth's height on the cheeks, up again before
  // the ears.
  const double edge_mm = 0.7 * nose_mm - 12.0 * std::exp(-std::pow((aside - 38.0) / 16.0, 2)) +
                         45.0 * smoothStep((aside - 55.0) / 20.0);
  const double below = smoothStep((edge_mm - from_mm.z()) / 6.0);
  const double lips = std::hypot(from_mm.x() / (1.05 * half_width_mm), from_mm.z() / 10.0);
  const double neck = smoothStep((p_mm.z() - (l[8].z() - 30.0)) / 15.0);
  const double front = smoothStep((p_mm.y() - (mouth_mm.y() - 95.0)) / 15.0);
  return below * smoothStep((lips - 0.9) / 0.3) * neck * front;
}

}  // namespace

VirtualPatient withBeard(const VirtualPatient& patient, double thickest_mm, std::uint64_t seed) {
  VirtualPatient bearded = patient;
  if (patient.landmarks68_mm.empty()) return bearded;
  const Eigen::Vector3d shift = Eigen::Vector3d::Constant(double(seed % 1000) * 3.7);
  for (std::size_t i = 0; i < patient.skin.vertices_mm.size(); ++i) {
    const Eigen::Vector3d& p_mm = patient.skin.vertices_mm[i];
    const double share = beardAt(patient.landmarks68_mm, p_mm);
    if (share <= 0.0) continue;
    const double wave = std::clamp(0.6 + 0.2 * sharedNoise().at(p_mm + shift, 5.0), 0.0, 1.0);
    bearded.hair[i] = std::max(bearded.hair[i], float(std::min(1.0, 1.2 * share * (0.4 + 0.6 * wave))));
    bearded.visible.vertices_mm[i] += share * wave * thickest_mm * patient.skin.normals[i];
  }
  bearded.visible.normals = vertexNormals(bearded.visible.vertices_mm, bearded.visible.triangles);
  return bearded;
}

}  // namespace facenav::room
