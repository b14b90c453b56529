#include "facenav/room/person_shape.h"

#include "optics/noise_field.h"
#include "skin_mesh.h"
#include "skin_texture.h"

namespace facenav::room {
namespace {

constexpr double kSoftScale_mm = 14.0;

}  // namespace

Eigen::Vector3d PersonShape::operator()(const Eigen::Vector3d& p_mm) const {
  const Eigen::Vector3d q = p_mm + noise_mm;
  const Eigen::Vector3d soft(sharedNoise().at(q, kSoftScale_mm),
                             sharedNoise().at(q + 300.0 * Eigen::Vector3d::UnitX(), kSoftScale_mm),
                             sharedNoise().at(q + 300.0 * Eigen::Vector3d::UnitY(), kSoftScale_mm));
  return centre_mm + scale.cwiseProduct(p_mm - centre_mm) + soft_mm * soft;
}

VirtualPatient shapedLike(const VirtualPatient& patient, const PersonShape& shape,
                          std::uint64_t complexion_seed, bool is_mirrored) {
  VirtualPatient person = patient;
  for (auto* mesh : {&person.skin, &person.visible}) {
    for (auto& p_mm : mesh->vertices_mm) p_mm = shape(p_mm);
    mesh->normals = vertexNormals(mesh->vertices_mm, mesh->triangles);
  }
  for (auto& p_mm : person.landmarks68_mm) p_mm = shape(p_mm);
  person.head_centre = Point<Mri>(shape(patient.head_centre.mm));
  person.face_middle = Point<Mri>(shape(patient.face_middle.mm));
  person.tone = complexion(person.skin.vertices_mm, complexion_seed, patient.others_contrast);
  person.texture = std::make_shared<SkinTexture>(person.landmarks68_mm, person.head_centre.mm, is_mirrored);
  return person;
}

}  // namespace facenav::room
