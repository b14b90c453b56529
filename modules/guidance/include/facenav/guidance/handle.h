#pragma once
// The handle of a planned coil: its signed angle and its gap, read back from a target; and a target moved
// along the scalp. The angle is the one that planTarget takes.

#include <cmath>

#include "facenav/guidance/target.h"

namespace facenav::guidance {

/// What a handle's angle of 0 points to.
enum class HandleReference { anterior, superior };

struct HandleAngle {
  /// -pi..pi, from the reference, in the plane tangent to the scalp; > 0 turns towards the midline.
  double angle_rad = 0;
  HandleReference reference = HandleReference::anterior;
};

/// Angle between the reference, projected onto the coil's plane, and the coil's y. The reference is anterior.
/// Where anterior's projection is shorter than 0.436 (coil axis within 26 degrees of anterior or posterior:
/// forehead and occiput) the reference is superior. Over the vertex anterior is tangent, so nothing changes
/// there. The midline is that of planTarget.
HandleAngle handleAngle(const Target& target, const surface::ScalpSurface& scalp);

/// Between contact face and scalp (hair), along the coil's z.
double hairGap_mm(const Target& target);

constexpr double kMostHandle_rad = M_PI;  // to either side
constexpr double kMostGap_mm = 20.0;      // hair, cap and electrodes; window and command line take no more

/// The target with its handle at an angle as handleAngle gives it; place and axis stay. Throws Error beyond
/// kMostHandle_rad.
Target withHandleAngle(const Target& target, const surface::ScalpSurface& scalp, double angle_rad);
/// The target with another gap, along the coil's z. Throws Error outside 0..kMostGap_mm.
Target withHairGap(const Target& target, double gap_mm);

/// The target moved by x and y (its own axes, mm) along the scalp. Depth under the scalp, gap, name and note
/// stay; the handle keeps its direction: the pose turns by the smallest rotation from the old z to the new
/// one. Throws like planTarget.
Target movedAlongScalp(const Target& target, const surface::ScalpSurface& scalp, double x_mm, double y_mm);

}  // namespace facenav::guidance
