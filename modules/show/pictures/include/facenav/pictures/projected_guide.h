#pragma once
// ProjectedGuide: the picture for a calibrated projector, whose light marks the coil's planned position on
// the patient's head: the outline of the coil with its handle, a ring round the target on the scalp, a second
// ring that shrinks to it as the coil approaches, and an arrow from the coil's side. It is drawn on the MRI's
// skin at the head's live pose, raised by the target's gap for hair. Black while the head is lost; without
// the coil's pose only the planned position is shown. Sizes are mm on the head.

#include <memory>
#include <optional>

#include "facenav/cameras/projector_model.h"
#include "facenav/core/rgb_image.h"
#include "facenav/guidance/coil_plate.h"
#include "facenav/guidance/guidance.h"
#include "facenav/surface/triangle_mesh.h"

namespace facenav::pictures {

class ProjectedGuide {
 public:
  /// Builds the guide. `scalp`: Mri, mm, with normals.
  ProjectedGuide(const cameras::ProjectorModel& projector, const surface::TriangleMesh& scalp,
                 const guidance::CoilPlate& plate);
  ~ProjectedGuide();
  ProjectedGuide(ProjectedGuide&&) noexcept;

  /// Draws a picture of the projector's size; black without `camera_T_mri`. `state`: the coil relative to the
  /// target; its values may be missing.
  RgbImage draw(const std::optional<RigidTransform<Camera, Mri>>& camera_T_mri,
                const guidance::Target& target, const guidance::GuidanceState& state);
  RgbImage black() const;
  /// Share of the ring round the target that the last picture lights, 0..1. Below 1, part of the skin faces
  /// away from the projector or lies outside its picture.
  double ringLit() const;
  const cameras::ProjectorModel& projector() const;

  static constexpr double kRing_mm = 14;          // radius of the ring round the target
  static constexpr double kWidestRing_mm = 70;    // the closing ring is never wider
  static constexpr double kOpening_per_mm = 2.0;  // growth of its radius per mm of distance

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace facenav::pictures
