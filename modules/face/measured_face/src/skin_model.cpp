#include "facenav/measured_face/skin_model.h"

namespace facenav::measured_face {

registration::SkinModel skinModel(const surface::ScalpSurface& scalp) {
  registration::SkinModel skin;
  skin.points.points_mm = scalp.mesh.vertices_mm;
  skin.points.normals = scalp.mesh.normals;
  skin.triangles = scalp.mesh.triangles;
  skin.field_of_view = scalp.field_of_view;
  skin.has_face = scalp.has_face;
  return skin;
}

}  // namespace facenav::measured_face
