#pragma once
// What the refined prior's doubt is stated as, by the contrast seen, so that as many places are stated in
// each band of doubt as have errors there.

#include "contrast_seen.h"
#include "facenav/segmentation/prior_use.h"

namespace facenav::segmentation {

/// v / (1 + v / most) with v = scale * (doubt / 1 mm)^power: rises with the doubt and stays below `most`.
float statedDoubt_mm(float doubt_mm, ContrastKind kind, const PriorUse& use);

}  // namespace facenav::segmentation
