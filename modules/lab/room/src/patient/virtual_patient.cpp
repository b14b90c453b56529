#include "facenav/room/virtual_patient.h"

#include <algorithm>
#include <cmath>

#include "facenav/core/error.h"
#include "landmarks.h"
#include "optics/noise_field.h"
#include "optics/ray_scene.h"
#include "skin_mesh.h"
#include "skin_texture.h"

namespace facenav::room {
namespace {

constexpr double kCrownToCentre_mm = 100.0;  // adult head: from the crown down to the brain case's centre

struct Box {
  Eigen::Vector3d low, high;
};

Box bounds(const std::vector<Eigen::Vector3d>& points) {
  Box box{points.front(), points.front()};
  for (const auto& p : points) box.low = box.low.cwiseMin(p), box.high = box.high.cwiseMax(p);
  return box;
}

/// Distance of a point from the border of the hair region, mm (negative: no hair). Hair grows above a plane
/// from the hairline on the forehead down to the nape behind the ears.
double insideHair_mm(const VirtualPatient& patient, const Eigen::Vector3d& p_mm) {
  const Eigen::Vector3d up_back = Eigen::Vector3d(0.0, -0.78, 0.62).normalized();
  // A point on the hairline: 62 mm above the root of the nose, or an estimate of it.
  Eigen::Vector3d hairline = patient.head_centre.mm + Eigen::Vector3d(0.0, 85.0, 30.0);
  if (!patient.landmarks68_mm.empty())
    hairline = patient.landmarks68_mm[27] + Eigen::Vector3d(0.0, -12.0, 62.0);
  const Eigen::Vector3d from = p_mm - hairline;
  const double sideburn = 10.0 * std::exp(-0.5 * std::pow((p_mm - patient.head_centre.mm).y() / 18.0, 2));
  const double nape = p_mm.z() - (patient.head_centre.mm.z() - 75.0);
  return std::min(from.dot(up_back) - sideburn + 4.0 * sharedNoise().at(p_mm, 9.0) - 22.0 * 0.0, nape);
}

void growHair(VirtualPatient& patient, const PatientOptions& options) {
  const Eigen::Vector3d shift = Eigen::Vector3d::Constant(double(options.seed % 1000) * 7.3);
  for (std::size_t i = 0; i < patient.skin.vertices_mm.size(); ++i) {
    const Eigen::Vector3d& p_mm = patient.skin.vertices_mm[i];
    const double inside = insideHair_mm(patient, p_mm);
    patient.hair[i] = float(std::clamp(inside / 3.0, 0.0, 1.0));
    const double rise = std::clamp(inside / 12.0, 0.0, 1.0);
    const double wave = std::clamp(
        0.5 + 0.22 * sharedNoise().at(p_mm + shift, 7.0) + 0.16 * sharedNoise().at(p_mm + shift, 1.6), 0.0,
        1.0);
    const double thickness =
        options.hair_thinnest_mm + wave * (options.hair_thickest_mm - options.hair_thinnest_mm);
    patient.visible.vertices_mm[i] += rise * thickness * patient.skin.normals[i];
  }
  patient.visible.normals = vertexNormals(patient.visible.vertices_mm, patient.visible.triangles);
}

}  // namespace

std::vector<float> complexion(const std::vector<Eigen::Vector3d>& skin_mm, std::uint64_t seed,
                              double contrast) {
  const Eigen::Vector3d shift(40.0 + double(seed % 1000) * 5.1, -70.0, 90.0);
  std::vector<float> tone;
  tone.reserve(skin_mm.size());
  for (const auto& p_mm : skin_mm) {
    const float freckle = std::clamp(sharedNoise().at(p_mm + shift, 1.1) - 2.0f, 0.f, 1.f);
    const float blotch = 0.05f * sharedNoise().at(p_mm - shift, 2.2);
    tone.push_back(std::max(0.3f, 1.f + float(contrast) * (blotch - 0.35f * freckle)));
  }
  return tone;
}

VirtualPatient makePatient(const surface::TriangleMesh& skin, const PatientOptions& options,
                           TaskMonitor& monitor) {
  monitor.report("virtual patient: face", 0.0);
  VirtualPatient patient;
  patient.skin = patient.visible = skin;
  patient.hair.assign(skin.vertices_mm.size(), 0.f);
  const Box box = bounds(skin.vertices_mm);
  const Eigen::Vector3d middle = 0.5 * (box.low + box.high);
  patient.head_centre = Point<Mri>(middle.x(), middle.y(), box.high.z() - kCrownToCentre_mm);
  if (const auto found = findHeadLandmarks(skin)) patient.landmarks68_mm = found->points68_mm;
  const auto& l = patient.landmarks68_mm;
  patient.face_middle = l.empty() ? Point<Mri>(patient.head_centre.mm + Eigen::Vector3d(0.0, 95.0, -30.0))
                                  : Point<Mri>(0.25 * (l[36] + l[45] + l[48] + l[54]));
  patient.texture = std::make_shared<SkinTexture>(l, patient.head_centre.mm);
  patient.tone = complexion(skin.vertices_mm, options.seed, options.skin_contrast);
  patient.pore_contrast *= float(options.skin_contrast);
  patient.skin_brightness = float(options.skin_brightness);
  if (options.has_hair) growHair(patient, options);
  monitor.report("virtual patient: face", 1.0);
  return patient;
}

VirtualPatient makePatient(const volume::Volume& mri, const PatientOptions& options, TaskMonitor& monitor) {
  return makePatient(makeSkinMesh(mri, monitor), options, monitor);
}

VirtualPatient withSkinContrast(const VirtualPatient& patient, double contrast) {
  VirtualPatient other = patient;
  for (float& tone : other.tone) tone = 1.f + float(contrast) * (tone - 1.f);
  other.pore_contrast *= float(contrast);
  other.others_contrast *= contrast;
  return other;
}

RigidTransform<Mri, frames::Target> leftHandArea(const VirtualPatient& patient, double gap_mm) {
  RayScene scene;
  scene.add(patient.skin);
  scene.commit();
  const Eigen::Vector3d out = Eigen::Vector3d(-0.58, -0.08, 0.81).normalized();
  const auto hit = scene.intersect(patient.head_centre.mm + 300.0 * out, -out);
  FACENAV_EXPECT(hit, "a head has a scalp over the hand area");
  // Normal of the scalp around the point, not of a single triangle.
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < patient.skin.vertices_mm.size(); ++i)
    if ((patient.skin.vertices_mm[i] - hit->p_object_mm).squaredNorm() < 100.0)
      normal += patient.skin.normals[i];
  const Eigen::Vector3d z = -normal.normalized();
  const Eigen::Vector3d forward_and_inward(1.0, 1.0, 0.0);
  const Eigen::Vector3d y = (forward_and_inward - forward_and_inward.dot(z) * z).normalized();
  Eigen::Matrix3d axes;
  axes << y.cross(z), y, z;
  return {Eigen::Quaterniond(axes), hit->p_object_mm - gap_mm * z};
}

}  // namespace facenav::room
