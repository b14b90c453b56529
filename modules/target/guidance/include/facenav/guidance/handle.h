#pragma once
// The handle of a planned coil: reads its signed angle, its gap and its depth from a target, and moves a
// target along the scalp. The angle is defined as in planTarget.

#include <cmath>

#include "facenav/guidance/target.h"

namespace facenav::guidance {

/// Direction of handle angle 0.
enum class HandleReference { anterior, superior };

struct HandleAngle {
  /// Handle angle from the reference, -pi..pi, in the plane tangent to the scalp; > 0 turns towards the
  /// midline.
  double angle_rad = 0;
  HandleReference reference = HandleReference::anterior;
};

/// Angle between the reference, projected onto the coil's plane, and the coil's y. The reference is anterior,
/// or superior where the projection of anterior is shorter than 0.436 (coil axis within 26 degrees of
/// anterior or posterior: forehead and occiput). Over the vertex anterior is tangent to the scalp, so the
/// reference stays anterior. The midline is that of planTarget.
HandleAngle handleAngle(const Target& target, const surface::ScalpSurface& scalp);

/// Returns the gap kept for hair: between the contact face and the scalp that the plate touches, along the
/// coil's z. The skin under the coil's centre may lie deeper by target.lift_mm.
double hairGap_mm(const Target& target);
/// Returns the gap between the contact face's centre and the skin beneath it: hairGap_mm plus target.lift_mm.
/// Compare a gap measured at the coil's centre with this one.
double centreGap_mm(const Target& target);

/// Returns how deep the cortex point lies below the scalp, along the coil's axis, mm. This is the depth of a
/// target wherever one is stated; gap and lift are not part of it.
double cortexDepth_mm(const Target& target);

constexpr double kMostHandle_rad = M_PI;  // largest angle to either side
constexpr double kMostGap_mm = 20.0;      // hair, cap and electrodes; the largest gap that is accepted

/// Returns the target with its handle at a given angle (as in handleAngle); position and axis do not change.
/// Throws Error beyond kMostHandle_rad.
Target withHandleAngle(const Target& target, const surface::ScalpSurface& scalp, double angle_rad);
/// Returns the target with another gap, along the coil's z. Throws Error outside 0..kMostGap_mm.
Target withHairGap(const Target& target, double gap_mm);

/// Returns the target moved along the scalp by x and y (its own axes, mm). The way begins under the plate's
/// centre, wherever the cortex point lies, and is measured on the skin. The cortex point moves with the
/// plate: it keeps its place under it. Depth under the scalp, gap, name and note do not change. The handle
/// keeps its direction: the pose turns by the smallest rotation that carries the skin's mean normal along.
/// Throws Error where the scalp ends.
Target movedAlongScalp(const Target& target, const surface::ScalpSurface& scalp, double x_mm, double y_mm);

}  // namespace facenav::guidance
