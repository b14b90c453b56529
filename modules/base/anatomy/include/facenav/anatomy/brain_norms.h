#pragma once
// Size of the brain, and the position of its hand area. Preparation and sign-off judge the brain by
// kNormalBrain, segmentation rejects masks outside kPossibleBrain, planning starts from the hand area.

#include <Eigen/Geometry>
#include <optional>
#include <string>

#include "facenav/anatomy/norm.h"

namespace facenav::anatomy {

/// Volume of a brain mask with closed sulci: it includes the fluid in them.
inline constexpr Norm kNormalBrain("brain with cerebellum", "ml", 1100, 1700, "adults, both sexes",
                                   "agrees with the skull's inside, 1106 to 1656 ml (58 adults of 18 to 95 "
                                   "years, doi 10.1007/s00276-010-0650-4), and "
                                   "with brains of 1173 to 1626 ml (20 young adults, Filipek 1994, doi "
                                   "10.1093/cercor/4.4.344), rounded outwards");
/// A mask outside this range is not accepted as a brain. Larger heads allow more: see the next two norms.
inline constexpr Norm kPossibleBrain(
    "brain with cerebellum", "ml", 600, 2200, "all whom rTMS treats",
    "judgement: 791 to 1500 ml of tissue in 58 adults (doi 10.1007/s00276-010-0650-4), with a wide margin");
inline constexpr Norm kLargestBrain(
    "brain with cerebellum, of any head", "ml", 0, 2600, "templates",
    "judgement: MNI's template, Colin27, enlarged by 1.1 measures 2353 ml and passes");
inline constexpr Norm kBrainPerHeadBall(
    "brain's volume over that of the ball which the head's top and girth let expect", "1", 0, 1.3, "any head",
    "fitted: on three heads, 0.94 to 1.19");

/// Finding for an unusual volume: "the brain measures 905 ml, adults have 1100 to 1700 ml: check its
/// outline"; nullopt for a normal one.
std::optional<std::string> brainVolumeFinding(double volume_ml);

/// No cortex lies deeper than this below the brain's hull: the insula lies at 20 to 25 mm.
inline constexpr double kDeepestSulcus_mm = 25;
/// Depth of an aimed place below the scalp. Deeper places are not cortex under that scalp.
inline constexpr Norm kTargetDepth("aimed place below the scalp", "mm", 1, 80, "any head",
                                   "judgement, with a wide margin");

/// The hand area of the left primary motor cortex ("hand knob", Yousry 1997, doi 10.1093/brain/120.1.141),
/// MNI mm. The source of the coordinates was not recorded. The right one is its mirror image.
inline const Eigen::Vector3d kLeftHandKnob_mm(-37, -21, 58);
/// Extent of the brain of MNI's single-subject template Colin27 (ch2bet.nii.gz of mricron), MNI mm.
inline const Eigen::AlignedBox3d kTemplateBrain_mm(Eigen::Vector3d(-72, -106, -67),
                                                   Eigen::Vector3d(71, 73, 84));

}  // namespace facenav::anatomy
