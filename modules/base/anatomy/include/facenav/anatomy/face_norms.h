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

/// Tests whether the skin of a scan has a face: defaced or cut scans fail. See facenav/anatomy/nose.h.
inline constexpr Norm kNoseRise("nose before the face, more than the forehead is", "mm", 8, kNoLimit,
                                "adults", "fitted: on the heads at hand, 17 to 22");
inline constexpr Norm kSocketDepth("eyes behind the brow", "mm", 2.5, kNoLimit, "adults",
                                   "fitted: on the heads at hand, 11 to 17");
inline constexpr Norm kUnevenFace("median difference of both sides of the face", "mm", 0, 6, "adults",
                                  "fitted: on the heads at hand, 1 to 3; a face cut away has 9");

}  // namespace facenav::anatomy
