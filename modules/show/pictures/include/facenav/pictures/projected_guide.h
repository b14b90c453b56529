#pragma once
// ProjectedGuide: the picture that a calibrated projector shows, so that its light lies on the patient's head
// where the coil belongs: the outline of the coil's place with its handle, a ring round the target's place on
// the scalp, a second ring that closes on it as the coil comes near, and an arrow from the coil's side. It is
// drawn on the MRI's skin at the head's live pose, raised by the target's gap for hair. Black while the head
// is lost; without the coil's pose only its place is shown. Sizes are mm on the head.

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
  /// `scalp`: Mri, mm, with normals.
  ProjectedGuide(const cameras::ProjectorModel& projector, const surface::TriangleMesh& scalp,
                 const guidance::CoilPlate& plate);
  ~ProjectedGuide();
  ProjectedGuide(ProjectedGuide&&) noexcept;

  /// Of the projector's size; black without `camera_T_mri`. `state`: of the coil against the target; its
  /// values may be missing.
  RgbImage draw(const std::optional<RigidTransform<Camera, Mri>>& camera_T_mri,
                const guidance::Target& target, const guidance::GuidanceState& state);
  RgbImage black() const;
  /// Share of the ring round the target that the last picture lights, 0..1. Below 1 the projector's light
  /// does not reach all of it: the skin there faces away, or lies outside the picture.
  double ringLit() const;
  const cameras::ProjectorModel& projector() const;

  static constexpr double kRing_mm = 14;          // radius of the ring round the target
  static constexpr double kWidestRing_mm = 70;    // the closing ring is never wider
  static constexpr double kOpening_per_mm = 2.0;  // its radius grows by this with each mm of distance

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace facenav::pictures
