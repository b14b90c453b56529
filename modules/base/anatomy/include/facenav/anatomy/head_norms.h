#pragma once
// Size of the head in mm and ml: the least that a scan must show of a head, and how far a head extends around
// its face. Norms that a person's face and head are compared with are in face_norms.h.

#include "facenav/anatomy/norm.h"

namespace facenav::anatomy {

/// An object in the scan with less volume is no head. Slabs and children pass.
inline constexpr Norm kScannedHead("volume of what a scan shows of a head", "ml", 300, kNoLimit,
                                   "children and adults", "judgement: a slab through a child's head");
inline constexpr Norm kScannedHeadMiddle("second longest edge of the box around it", "mm", 80, kNoLimit,
                                         "children and adults", "judgement, as above");
inline constexpr Norm kScannedHeadShortest("shortest edge of the box around it", "mm", 25, kNoLimit,
                                           "children and adults", "judgement, as above");
/// A virtual patient needs a whole head, not a slab.
inline constexpr Norm kWholeHead("volume of a whole head", "ml", 800, kNoLimit, "children and adults",
                                 "judgement");
/// A scan that is shorter in one direction shows no whole brain.
inline constexpr Norm kScanOfBrain(
    "shortest edge of a scan of the brain", "mm", 100, kNoLimit, "children and adults",
    "judgement; the template's brain measures 143 x 179 x 151 mm (brain_norms.h)");
/// Radius of the disc that has the area of a large axial slice; 84 in adults, less in children.
inline constexpr Norm kGirthRadius("radius of the head's girth", "mm", 50, 125, "children and adults",
                                   "judgement: from a child's head to one with shoulders in the slice");

/// Height of the head from vertex to chin; neck and shoulders lie below. Judgement.
inline constexpr double kHeadHeight_mm = 200;
/// Distance from the middle between eyes and mouth to chin, temples and forehead, all around. Judgement.
inline constexpr double kFaceReach_mm = 135;
/// Distance from the face's centre to the cortex behind it, where errors and motion count. Judgement.
inline constexpr double kFaceToCortex_mm = 90;
/// Depth of a head behind its face: the longest head (face_norms.h, 214) and a nose. Judgement.
inline constexpr double kHeadDepth_mm = 220;

}  // namespace facenav::anatomy
