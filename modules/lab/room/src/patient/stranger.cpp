#include "stranger.h"

#include <random>

#include "optics/noise_field.h"
#include "skin_mesh.h"
#include "skin_texture.h"

namespace facenav::room {
namespace {

constexpr double kSoftTissue_mm = 2.5, kSoftScale_mm = 14.0;  // beyond the proportions

struct Deformation {
  Eigen::Vector3d centre, scale, shift;

  Eigen::Vector3d operator()(const Eigen::Vector3d& p_mm) const {
    const Eigen::Vector3d q = p_mm + shift;
    const Eigen::Vector3d soft(sharedNoise().at(q, kSoftScale_mm),
                               sharedNoise().at(q + 300.0 * Eigen::Vector3d::UnitX(), kSoftScale_mm),
                               sharedNoise().at(q + 300.0 * Eigen::Vector3d::UnitY(), kSoftScale_mm));
    return centre + scale.cwiseProduct(p_mm - centre) + 0.5 * kSoftTissue_mm * soft;
  }
};

Deformation deformationOf(const VirtualPatient& patient, std::uint64_t seed) {
  std::mt19937_64 random(seed * 31 + 5);
  const auto away = [&random] {  // 4 to 9 % larger or smaller
    const double size = 0.04 + 0.05 * double(random() >> 11) * 0x1p-53;
    return 1.0 + (random() % 2 ? size : -size);
  };
  Deformation deformation;
  deformation.centre = patient.face_middle.mm;
  deformation.scale = {away(), away(), away()};
  deformation.shift = Eigen::Vector3d(51.0, 17.0, 23.0) * double(1 + seed % 97);
  return deformation;
}

}  // namespace

std::shared_ptr<const VirtualPatient> strangerLike(const VirtualPatient& patient, std::uint64_t seed) {
  const Deformation deformed = deformationOf(patient, seed);
  auto stranger = std::make_shared<VirtualPatient>(patient);
  for (auto* mesh : {&stranger->skin, &stranger->visible}) {
    for (auto& p_mm : mesh->vertices_mm) p_mm = deformed(p_mm);
    mesh->normals = vertexNormals(mesh->vertices_mm, mesh->triangles);
  }
  for (auto& p_mm : stranger->landmarks68_mm) p_mm = deformed(p_mm);
  stranger->head_centre = Point<Mri>(deformed(patient.head_centre.mm));
  stranger->face_middle = Point<Mri>(deformed(patient.face_middle.mm));
  stranger->tone = complexion(stranger->skin.vertices_mm, seed + 500, patient.others_contrast);
  stranger->texture = std::make_shared<SkinTexture>(stranger->landmarks68_mm, stranger->head_centre.mm, true);
  return stranger;
}

}  // namespace facenav::room
