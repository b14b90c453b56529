#pragma once
// Whether it is the patient's skin that a fitted pose lies on. Faces resemble each other in all that is
// coarse: eyes, brows and mouth of another person, laid over the patient's, pass for them patch by patch.
// The fine detail (pores, freckles, single hairs: some 2 to 5 pixels) is each person's own. So the patches
// are compared in that band alone, and all of them that do not plainly show something else are pooled: the
// agreement is 1 where all detail that stands out of the noise is the patient's (noise lowers what is
// expected, not the agreement), and near 0 where it is not. Only edges that all faces share, and that the fit
// has laid over each other, keep it from 0. Measured in the virtual room, heads turned by up to 30 deg, at
// every pose that was fitted, in parts of what both cameras agree on in the reference (least, median, most):
//
// | heads                                           | the patient        | others               |
// |-------------------------------------------------|--------------------|----------------------|
// | three, one dark, 3 rigs: 24 poses, 24 others    | 0.80 / 0.91 / 0.99 | -0.06 / 0.14 / 0.34  |
// | one, recorded as JPEG of quality 75: 5 poses, 5 | 0.86 / 0.92 / 0.96 |  0.00 / 0.11 / 0.24  |

#include <array>

#include "patch_model.h"
#include "patch_placement.h"
#include "pose_fit.h"

namespace facenav::head_tracking {

/// Sums over patches and cameras.
struct DetailAgreement {
  double product = 0.0;   // of the correlations seen and expected
  double expected = 0.0;  // of the squares of those expected, by noise alone

  double value() const;
  double sigma() const;  // by noise and chance
};

/// Of the face where `fit` lies, against the key frame that it was fitted with. `now`: level 0 at least;
/// `share`: of the patches (a part of them is enough while tracking).
DetailAgreement detailAgreement(const cameras::StereoRig& rig, const PatchModel& model,
                                const PatchLevel& finest, const std::array<ImagePyramid, 2>& now,
                                const PoseFit& fit, const PatchShare& share = {});

/// Of the left and the right reference image, which show the same skin: what these cameras and this skin
/// allow.
DetailAgreement detailOfBothCameras(const PatchModel& model);

/// What the two mean, with three standard errors on either side; undecided in between (dark, blurred, far).
enum class Whose { patients, undecided, anothers };
Whose whoseSkin(const DetailAgreement& seen, const DetailAgreement& of_both_cameras);

}  // namespace facenav::head_tracking
