#pragma once
// Distances between anthropometric landmarks of face and head (names and definitions: Farkas, Anthropometry
// of the Head and Face, 1994), with their adult ranges: means of both sexes with two standard deviations over
// the widest populations found, rounded outwards. Children differ. The import check applies them to the
// scan's skin; the face search in images uses the distance of the eyes.

#include <optional>
#include <vector>

#include "facenav/anatomy/norm.h"

namespace facenav::anatomy {

struct FaceNorm {
  const char *name, *from, *to;  // plain words, then the two landmarks
  std::optional<Norm> adults;    // nullopt where no range was found
};

/// Distances between two landmarks, in the order of reports.
const std::vector<FaceNorm>& faceNorms();

inline constexpr Norm kHeadCircumference(
    "circumference of the head over glabella and opisthocranion", "mm", 515, 615, "adults, both sexes",
    "ANSUR II 2012, men 574 (16), women 561 (19); NIOSH 2003, men 576 (18), women 559 (21)");
inline constexpr Norm kPupils("distance of the pupils", "mm", 51, 77, "adults, both sexes", "ANSUR II 2012");
/// Distance between two triangulated groups of landmarks, one per eye. Outside this range they are no face,
/// or two faces.
inline constexpr Norm kEyesInSpace("distance of the eyes, triangulated", "mm", kPupils.low - 6,
                                   kPupils.high + 8, "adults, both sexes",
                                   "the pupils' range with a margin for landmarks placed badly");

/// Limits of the face check (surface's face_check.h). Chosen on eight labelled heads with even numbers,
/// painted as T1, and on faces removed, filled with noise, sheared off, blurred by 4 and 7 mm and smoothed by
/// 10 mm from five of them.
inline constexpr Norm kFaceLikeness("correlation of the skin's relief with the mean face", "1", 0.70, 1,
                                    "adults", "fitted: whole 0.79 to 0.98, removed 0.35 to 0.63");
inline constexpr Norm kFaceEdge("width of the skin's edge in the face over that of the upper head", "1", 0,
                                1.8, "any head", "fitted: whole 0.98 to 1.15, blurred 2.8 to 3.9");
/// A smoothed face lies below both of these.
inline constexpr Norm kFaceDetail("fine relief of the face over that of the forehead", "1", 1.5, kNoLimit,
                                  "adults",
                                  "fitted: whole 2.7 to 4.9 (one torn nose 1.2), smoothed 0.8 to 1.1");
inline constexpr Norm kFaceStrength("height of the face's relief over the mean face's", "1", 0.62, kNoLimit,
                                    "adults", "fitted: whole 0.78 to 1.12, smoothed 0.37 to 0.57");
/// A face that is less like one, or has wider edges, is usable with a caution.
inline constexpr double kClearFaceLikeness = 0.8, kClearFaceEdge = 1.4;

}  // namespace facenav::anatomy
