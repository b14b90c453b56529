#include "facenav/room/world.h"

namespace facenav::room {
namespace {

VirtualPatient withoutHair(VirtualPatient patient) {
  patient.visible = patient.skin;
  patient.hair.assign(patient.hair.size(), 0.f);
  return patient;
}

}  // namespace

PersonShape shapeOf(const World& world, const VirtualPatient& head) {
  PersonShape shape;
  shape.centre_mm = head.face_middle.mm;
  shape.scale = world.person.scale;
  shape.soft_mm = world.person.soft_mm;
  shape.noise_mm = Eigen::Vector3d(51.0, 17.0, 23.0) * double(1 + world.person.tissue % 997);
  return shape;
}

VirtualPatient personOf(const World& world, const VirtualPatient& head) {
  const WorldPerson& drawn = world.person;
  VirtualPatient person = shapedLike(drawn.is_bald ? withoutHair(head) : head, shapeOf(world, head),
                                     drawn.tissue, drawn.is_mirrored);
  person = withSkinContrast(person, drawn.skin_contrast);
  person.skin_brightness = float(drawn.skin_brightness);
  return drawn.beard_mm > 0.0 ? withBeard(person, drawn.beard_mm, drawn.tissue) : person;
}

}  // namespace facenav::room
